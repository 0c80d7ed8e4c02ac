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
  /// Empty: the answer comes later, and nothing is asked before.
  virtual std::string answer(const std::string& request) = 0;
  virtual std::string late_answer() { return {}; }  ///< empty: not yet
  /// What is to be said unasked; empty: nothing. Only asked while the client has taken all that was said
  /// before.
  virtual std::string news(double /*now_s*/) { return {}; }
  /// Instead, while it has not.
  virtual void news_not_taken(double /*now_s*/) {}
  virtual bool wants_news() const { return false; }  ///< a client that says nothing is not idle
  virtual bool over() const { return false; }        ///< close once the last words are sent
};

/// Splits what clients send into requests and sends back what their conversations say. A client has one
/// answer at a time under way: what it does not take is never more than that, and it is not read meanwhile.
/// One that sends more than 64 KiB without a request is closed, and one that asks nothing for too long. There
/// are 32 places, 8 of them for one peer (an address, a process); the next client takes the place of the one
/// that has been silent longest. Thread: CT.
class LineServer {
 public:
  struct Protocol {
    std::string end_of_request;  ///< "\n", or "\r\n\r\n" for HTTP
    double idle_s;               ///< a client without a request for so long is closed
    std::function<std::unique_ptr<Conversation>()> begin;
  };

  LineServer(FileDescriptor listening, Protocol protocol);

  void add_polls(std::vector<pollfd>& polls) const;  ///< every descriptor it waits for
  /// Whatever is ready now, one request a client; never waits. Returns whether more can be done at once.
  bool serve();
  /// Asks every conversation for news, and closes who was idle for too long. To be called now and then.
  void tell_news(double now_s);

 private:
  struct Client {
    FileDescriptor fd;
    std::string peer;
    std::unique_ptr<Conversation> conversation;
    std::string in, out;
    std::size_t asked = 0, told = 0;  ///< of `in` and `out`, from the front: done with
    bool ended = false;               ///< sends no more
    bool waits = false;               ///< for a late answer
    std::uint64_t turn = 0;           ///< when it last took or said something, in turns of the server
    std::uint64_t turn_seen = 0;      ///< the turn that was its last at `seen_s`
    double seen_s = 0;
  };
  void accept_all();
  void make_room(const std::string& peer);
  bool serve(Client& client);
  bool receive(Client& client) const;
  bool send(Client& client);
  std::size_t end_of_request(const Client& client) const;
  bool has_request(const Client& client) const;
  bool news(Client& client, double now_s);

  FileDescriptor listening_;
  Protocol protocol_;
  std::vector<Client> clients_;
  std::uint64_t turn_ = 0;
};

}  // namespace rigsound::daemon
