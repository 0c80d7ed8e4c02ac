#include "modbus/tcp_server.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>

#include <algorithm>
#include <cerrno>

#include "modbus/rtu_frame.hpp"
#include "modbus/tcp_frame.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/monotonic_time.hpp"
#include "rigsound/socket/tcp_listener.hpp"

namespace rigsound::modbus {
namespace {

constexpr int kMostAtOnce = 64;  // connections taken in one round: those that are there want to be served

}  // namespace

TcpServer::TcpServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap)
    : ModbusServer(options, listener, tap), context_(make_context(options)) {}

int TcpServer::port() const { return bound_port(listening_); }

void TcpServer::step() {
  if (!listening_) {
    if (may_open()) listen();
    return;
  }
  std::vector<pollfd> polls = {stop_event().to_poll(), {listening_.get(), POLLIN, 0}};
  for (const Connection& c : connections_) polls.push_back({c.fd.get(), POLLIN, 0});
  if (::poll(polls.data(), polls.size(), kRound_ms) < 0) return;
  for (std::size_t i = 0; i < connections_.size(); ++i)
    if (polls[i + 2].revents != 0 && !serve(connections_[i])) connections_[i].fd.reset();
  // A connection that wrote and closed within one round was a master all the same.
  note_masters();
  forget_closed();
  note_masters();
  if (polls[1].revents != 0) accept_all();
  open_.store(connections_.size(), std::memory_order_relaxed);
}

void TcpServer::listen() {
  try {
    listening_ = listen_tcp({options().host, options().port}, stop_event());
    report_up();
  } catch (const DeviceError& error) {
    const bool taken = errno == EADDRINUSE;
    open_failed(error.what() +
                std::string(taken ? ": another program listens there; beside a running rigsoundd "
                                    "its own --session is the record"
                                  : ""));
  }
}

void TcpServer::accept_all() {
  for (int i = 0; i < kMostAtOnce; ++i) {
    sockaddr_storage peer{};
    socklen_t size = sizeof peer;
    FileDescriptor fd(
        ::accept4(listening_.get(), reinterpret_cast<sockaddr*>(&peer), &size, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!fd) return;
    if (!allowed(address_bytes(peer), options().allow)) {
      count_.rejected_connections.fetch_add(1, std::memory_order_relaxed);
      const char* const why = "not in an allowed network";
      warn(why, address_text(peer) + ": connection rejected: " + why);
      continue;
    }
    make_room(address_text(peer));
    const int on = 1;
    ::setsockopt(fd.get(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    Connection connection;
    connection.fd = std::move(fd);
    connection.peer = address_text(peer);
    connection.last_ms = monotonic_ms();
    connections_.push_back(std::move(connection));
  }
}

/// Who writes is the last to go.
void TcpServer::make_room(const std::string& peer) {
  const auto silent_longer = [](const Connection& a, const Connection& b) {
    return a.wrote != b.wrote ? b.wrote : a.last_ms < b.last_ms;
  };
  const auto goes = who_makes_room(connections_, peer, kPlaces, silent_longer);
  if (goes == connections_.end()) return;
  count_.evicted_connections.fetch_add(1, std::memory_order_relaxed);
  warn("too many connections", goes->peer + ": too many connections, the one silent longest was closed");
  connections_.erase(goes);
}

/// Returns false when the connection is to be closed.
bool TcpServer::serve(Connection& c) {
  const ssize_t got = ::recv(c.fd.get(), c.bytes.data() + c.filled, c.bytes.size() - c.filled, 0);
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  if (got == 0) return false;
  c.filled += got;
  return answer_whole_frames(c);
}

std::optional<TcpServer::Frame> TcpServer::first_frame(const Connection& c) const {
  if (options().transport == Transport::kRtuTcp) {
    const auto size = rtu_frame_size(RtuSide::kRequest, c.bytes.data(), c.filled);
    if (!size) return std::nullopt;
    if (*size == 0 || c.filled < *size) return Frame{};
    if (!rtu_checksum_holds(c.bytes.data(), *size)) return std::nullopt;
    return Frame{*size, *size - kRtuEnds};
  }
  const auto size = tcp_frame_size(c.bytes.data(), c.filled);
  if (!size) return std::nullopt;
  return *size == 0 || c.filled < *size ? Frame{} : Frame{*size, *size - kMbap};
}

bool TcpServer::answer_whole_frames(Connection& c) {
  for (;;) {
    const auto frame = first_frame(c);
    if (!frame) return bad_frame(c, "not Modbus"), false;
    if (frame->size == 0) return true;
    c.last_ms = monotonic_ms();
    const std::uint64_t writes_before = writes();
    modbus_set_socket(context_.get(), c.fd.get());
    const Reply reply =
        respond(context_.get(), c.bytes.data(), static_cast<int>(frame->size), frame->pdu_size, c.peer);
    modbus_set_socket(context_.get(), -1);
    c.wrote = c.wrote || writes() != writes_before;
    if (reply == Reply::kFailed) return false;
    std::copy(c.bytes.begin() + static_cast<std::ptrdiff_t>(frame->size),
              c.bytes.begin() + static_cast<std::ptrdiff_t>(c.filled), c.bytes.begin());
    c.filled -= frame->size;
  }
}

/// What a master wrote stands while one is there, and a little longer: some connect for every write.
void TcpServer::note_masters() {
  if (options().master_gone_after_s == 0) return;
  const bool any =
      std::any_of(connections_.begin(), connections_.end(), [](const Connection& c) { return c.wrote; });
  if (any) {
    had_master_ = true;
    gone_ms_ = 0;
    return;
  }
  if (!had_master_) return;
  const std::int64_t now_ms = monotonic_ms();
  if (gone_ms_ == 0) gone_ms_ = now_ms;
  if (static_cast<double>(now_ms - gone_ms_) < options().master_gone_after_s * 1e3) return;
  had_master_ = false;
  gone_ms_ = 0;
  report_all(Validity::kBusDown);
  warn("master gone",
       "the last connection that wrote has closed: its signals obey their safety rules "
       "(master_gone_after_ms)");
}

void TcpServer::bad_frame(const Connection& connection, const char* what) {
  count_.bad_frames.fetch_add(1, std::memory_order_relaxed);
  warn(what, connection.peer + ": " + what + ", connection closed");
}

void TcpServer::forget_closed() {
  const std::int64_t now = monotonic_ms();
  const auto over = [now](const Connection& c) { return !c.fd || now - c.last_ms > kIdle_ms; };
  connections_.erase(std::remove_if(connections_.begin(), connections_.end(), over), connections_.end());
}

}  // namespace rigsound::modbus
