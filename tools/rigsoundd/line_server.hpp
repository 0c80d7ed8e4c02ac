// Clients on a socket, one request and one answer at a time, all in the caller's thread.
#pragma once

#include <poll.h>

#include <functional>
#include <string>
#include <vector>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::daemon {

/// Splits what clients send into requests and sends back what `answer` says. A client that sends more than
/// 64 KiB without a request, or does not take its answers, is closed. Thread: CT.
class LineServer {
 public:
  struct Protocol {
    std::string end_of_request;  ///< "\n", or "\r\n\r\n" for HTTP
    bool one_request = false;    ///< close after the answer
    std::function<std::string(const std::string& request)> answer;
  };

  LineServer(FileDescriptor listening, Protocol protocol);

  void add_polls(std::vector<pollfd>& polls) const;  ///< every descriptor it waits for
  void serve();                                      ///< whatever is ready now; never waits

 private:
  struct Client {
    FileDescriptor fd;
    std::string in, out;
    bool closing = false;
  };
  void accept_all();
  bool serve(Client& client);

  FileDescriptor listening_;
  Protocol protocol_;
  std::vector<Client> clients_;
};

}  // namespace rigsound::daemon
