#include "line_server.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace rigsound::daemon {
namespace {

constexpr std::size_t kMaxRequest = 64 * 1024, kMaxClients = 32, kMaxUnsent = 4 << 20;

}  // namespace

LineServer::LineServer(FileDescriptor listening, Protocol protocol)
    : listening_(std::move(listening)), protocol_(std::move(protocol)) {}

void LineServer::add_polls(std::vector<pollfd>& polls) const {
  polls.push_back({listening_.get(), POLLIN, 0});
  for (const Client& c : clients_)
    polls.push_back({c.fd.get(), static_cast<short>(c.out.empty() ? POLLIN : POLLIN | POLLOUT), 0});
}

void LineServer::serve() {
  accept_all();
  const auto gone = [this](Client& c) { return !serve(c); };
  clients_.erase(std::remove_if(clients_.begin(), clients_.end(), gone), clients_.end());
}

void LineServer::accept_all() {
  while (true) {
    FileDescriptor fd(::accept4(listening_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!fd) return;
    if (clients_.size() >= kMaxClients) continue;
    Client client;
    client.fd = std::move(fd);
    clients_.push_back(std::move(client));
  }
}

/// Returns false when the client is to be closed.
bool LineServer::serve(Client& c) {
  std::array<char, 4096> bytes{};
  ssize_t got = 0;
  while ((got = ::recv(c.fd.get(), bytes.data(), bytes.size(), 0)) > 0) c.in.append(bytes.data(), got);
  const bool ended = got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR);
  for (std::size_t end = 0; !c.closing && (end = c.in.find(protocol_.end_of_request)) != std::string::npos;) {
    c.out += protocol_.answer(c.in.substr(0, end));
    c.in.erase(0, end + protocol_.end_of_request.size());
    c.closing = protocol_.one_request;
  }
  while (!c.out.empty()) {
    const ssize_t sent = ::send(c.fd.get(), c.out.data(), c.out.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EAGAIN) break;
    if (sent < 0) return false;
    c.out.erase(0, sent);
  }
  if (c.in.size() > kMaxRequest || c.out.size() > kMaxUnsent) return false;
  return !ended && !(c.closing && c.out.empty());
}

}  // namespace rigsound::daemon
