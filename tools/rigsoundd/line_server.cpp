#include "line_server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace rigsound::daemon {
namespace {

constexpr std::size_t kMaxRequest = 64 * 1024, kMaxClients = 32;

}  // namespace

LineServer::LineServer(FileDescriptor listening, Protocol protocol)
    : listening_(std::move(listening)), protocol_(std::move(protocol)) {}

void LineServer::add_polls(std::vector<pollfd>& polls) const {
  polls.push_back({listening_.get(), POLLIN, 0});
  for (const Client& c : clients_)
    polls.push_back({c.fd.get(), static_cast<short>(c.out.empty() ? POLLIN : POLLOUT), 0});
}

bool LineServer::serve() {
  ++turn_;
  accept_all();
  const auto gone = [this](Client& c) { return !serve(c); };
  clients_.erase(std::remove_if(clients_.begin(), clients_.end(), gone), clients_.end());
  return std::any_of(clients_.begin(), clients_.end(),
                     [this](const Client& c) { return c.out.empty() && has_request(c); });
}

void LineServer::accept_all() {
  for (std::size_t i = 0; i < kMaxClients; ++i) {
    FileDescriptor fd(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!fd) return;
    if (clients_.size() == kMaxClients)
      clients_.erase(std::min_element(clients_.begin(), clients_.end(),
                                      [](const Client& a, const Client& b) { return a.turn < b.turn; }));
    clients_.push_back({std::move(fd), protocol_.begin(), {}, {}, false, turn_});
  }
}

bool LineServer::has_request(const Client& c) const {
  return c.in.find(protocol_.end_of_request) != std::string::npos;
}

/// Returns false when the client is to be closed.
bool LineServer::serve(Client& c) {
  if (!send(c)) return false;
  if (!c.out.empty()) return true;
  if (!has_request(c) && !receive(c)) return false;
  if (!has_request(c)) return !c.ended;
  const std::size_t end = c.in.find(protocol_.end_of_request);
  c.out = c.conversation->answer(c.in.substr(0, end));
  c.in.erase(0, end + protocol_.end_of_request.size());
  c.turn = turn_;
  return send(c);
}

/// Returns false for what is no request.
bool LineServer::receive(Client& c) const {
  std::array<char, 4096> bytes{};
  while (c.in.size() <= kMaxRequest) {
    const ssize_t got = ::recv(c.fd.get(), bytes.data(), bytes.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    c.ended = got == 0 || (got < 0 && errno != EAGAIN);
    if (got <= 0) return true;
    c.in.append(bytes.data(), static_cast<std::size_t>(got));
  }
  return has_request(c);
}

/// Returns false when the client is gone, or has been told its last.
bool LineServer::send(Client& c) {
  while (!c.out.empty()) {
    const ssize_t sent = ::send(c.fd.get(), c.out.data(), c.out.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EAGAIN) return true;
    if (sent < 0) return false;
    c.out.erase(0, static_cast<std::size_t>(sent));
    c.turn = turn_;
  }
  return !c.conversation->over();
}

void LineServer::tell_news(double now_s) {
  const auto gone = [&](Client& c) {
    if (!c.out.empty()) {
      c.conversation->news_not_taken(now_s);
      return false;
    }
    c.out = c.conversation->news(now_s);
    return !c.out.empty() && !send(c);
  };
  clients_.erase(std::remove_if(clients_.begin(), clients_.end(), gone), clients_.end());
}

}  // namespace rigsound::daemon
