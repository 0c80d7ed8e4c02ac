#include "line_server.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "rigsound/socket/network.hpp"
#include "rigsound/socket/places.hpp"

namespace rigsound::daemon {
namespace {

constexpr std::size_t kMaxRequest = 64 * 1024;
constexpr Places kPlaces;

/// Who is at the other end: the process of a UNIX socket, the address of any other.
std::string peer_of(const FileDescriptor& fd) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getpeername(fd.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return {};
  if (address.ss_family != AF_UNIX) return address_text(address);
  ucred who{};
  size = sizeof who;
  return ::getsockopt(fd.get(), SOL_SOCKET, SO_PEERCRED, &who, &size) == 0 ? std::to_string(who.pid) : "";
}

}  // namespace

LineServer::LineServer(FileDescriptor listening, Protocol protocol)
    : listening_(std::move(listening)), protocol_(std::move(protocol)) {}

// Who waits is looked at anyway: poll() would tell at once, again and again, that it has hung up.
void LineServer::add_polls(std::vector<pollfd>& polls) const {
  polls.push_back({listening_.get(), POLLIN, 0});
  for (const Client& c : clients_)
    polls.push_back({c.waits && c.out.empty() ? -1 : c.fd.get(),
                     static_cast<short>(c.out.empty() ? POLLIN : POLLOUT), 0});
}

bool LineServer::serve() {
  ++turn_;
  accept_all();
  const auto gone = [this](Client& c) { return !serve(c); };
  clients_.erase(std::remove_if(clients_.begin(), clients_.end(), gone), clients_.end());
  return std::any_of(clients_.begin(), clients_.end(),
                     [this](const Client& c) { return c.out.empty() && !c.waits && has_request(c); });
}

void LineServer::accept_all() {
  for (std::size_t i = 0; i < kPlaces.all; ++i) {
    FileDescriptor fd(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!fd) return;
    Client client;
    client.peer = peer_of(fd);
    client.fd = std::move(fd);
    client.conversation = protocol_.begin();
    client.turn = turn_;
    make_room(client.peer);
    clients_.push_back(std::move(client));
  }
}

void LineServer::make_room(const std::string& peer) {
  const auto goes = who_makes_room(clients_, peer, kPlaces,
                                   [](const Client& a, const Client& b) { return a.turn < b.turn; });
  if (goes != clients_.end()) clients_.erase(goes);
}

std::size_t LineServer::end_of_request(const Client& c) const {
  return c.in.find(protocol_.end_of_request, c.asked);
}

bool LineServer::has_request(const Client& c) const { return end_of_request(c) != std::string::npos; }

/// Returns false when the client is to be closed.
bool LineServer::serve(Client& c) {
  if (!send(c)) return false;
  if (!c.out.empty()) return true;
  if (c.waits) {
    c.out = c.conversation->late_answer();
  } else {
    if (!has_request(c) && !receive(c)) return false;
    const std::size_t end = end_of_request(c);
    if (end == std::string::npos) return !c.ended;
    c.out = c.conversation->answer(c.in.substr(c.asked, end - c.asked));
    c.asked = end + protocol_.end_of_request.size();
    c.turn = turn_;
  }
  c.waits = c.out.empty();
  return send(c);
}

/// Returns false for what is no request.
bool LineServer::receive(Client& c) const {
  c.in.erase(0, c.asked);
  c.asked = 0;
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
  while (c.told < c.out.size()) {
    const ssize_t sent = ::send(c.fd.get(), c.out.data() + c.told, c.out.size() - c.told, MSG_NOSIGNAL);
    if (sent < 0 && errno == EAGAIN) return true;
    if (sent < 0) return false;
    c.told += static_cast<std::size_t>(sent);
    c.turn = turn_;
  }
  c.out.clear();
  c.told = 0;
  return c.waits || !c.conversation->over();
}

void LineServer::tell_news(double now_s) {
  const auto gone = [&](Client& c) { return !news(c, now_s); };
  clients_.erase(std::remove_if(clients_.begin(), clients_.end(), gone), clients_.end());
}

/// Returns false when the client is to be closed.
bool LineServer::news(Client& c, double now_s) {
  const bool active = c.turn != c.turn_seen || c.waits || c.conversation->wants_news();
  if (active) c.seen_s = now_s;
  c.turn_seen = c.turn;
  if (!active && now_s - c.seen_s > protocol_.idle_s) return false;
  if (!c.out.empty()) {
    c.conversation->news_not_taken(now_s);
    return true;
  }
  c.out = c.conversation->news(now_s);
  return c.out.empty() || send(c);
}

}  // namespace rigsound::daemon
