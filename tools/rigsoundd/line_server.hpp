// Clients on a socket, all in the caller's thread; none of them holds it up.
#pragma once

#include <poll.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::daemon {

/// What one client asks and is told. Thread: CT.
class Conversation {
 public:
  virtual ~Conversation() = default;
  virtual std::string answer(const std::string& request) = 0;
  /// What is to be said unasked; empty: nothing. Only asked while the client has taken all that was said
  /// before.
  virtual std::string news(double /*now_s*/) { return {}; }
  /// Instead, while it has not.
  virtual void news_not_taken(double /*now_s*/) {}
  virtual bool over() const { return false; }  ///< close once the last words are sent
};

/// Splits what clients send into requests and sends back what their conversations say. A client has one
/// answer at a time under way: what it does not take is never more than that, and it is not read meanwhile.
/// One that sends more than 64 KiB without a request is closed; when 32 are connected, the next takes the
/// place of the one that has been silent longest. Thread: CT.
class LineServer {
 public:
  struct Protocol {
    std::string end_of_request;  ///< "\n", or "\r\n\r\n" for HTTP
    std::function<std::unique_ptr<Conversation>()> begin;
  };

  LineServer(FileDescriptor listening, Protocol protocol);

  void add_polls(std::vector<pollfd>& polls) const;  ///< every descriptor it waits for
  /// Whatever is ready now, one request a client; never waits. Returns whether more can be done at once.
  bool serve();
  void tell_news(double now_s);  ///< asks every conversation for it

 private:
  struct Client {
    FileDescriptor fd;
    std::unique_ptr<Conversation> conversation;
    std::string in, out;
    bool ended = false;      ///< sends no more
    std::uint64_t turn = 0;  ///< when it last took or said something, in turns of the server
  };
  void accept_all();
  bool serve(Client& client);
  bool receive(Client& client) const;
  bool send(Client& client);
  bool has_request(const Client& client) const;

  FileDescriptor listening_;
  Protocol protocol_;
  std::vector<Client> clients_;
  std::uint64_t turn_ = 0;
};

}  // namespace rigsound::daemon
