#include "udp/udp_bus.hpp"

#include <netinet/in.h>
#include <poll.h>

#include <cerrno>
#include <cstring>

#include "bus/arrival_clock.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/socket/tcp_listener.hpp"

namespace rigsound::udp {
namespace {

constexpr int kRound_ms = 200;
constexpr int kReceiveBuffer = 4 << 20;   // bytes
constexpr std::size_t kMostSenders = 64;  // whose numbers are kept

/// The port lies alike in sockaddr_in6.
int port_of(const sockaddr_storage& peer) {
  return ntohs(reinterpret_cast<const sockaddr_in&>(peer).sin_port);
}

void count(std::atomic<std::uint64_t>& counter) { counter.fetch_add(1, std::memory_order_relaxed); }

}  // namespace

UdpBus::UdpBus(const UdpOptions& options, BusListener& listener, UdpTap* tap)
    : BusBase("udp " + options.address, targets(options.routes), listener),
      options_(options),
      tap_(tap),
      reader_(options.routes),
      bytes_(kBatch) {
  for (std::size_t i = 0; i < kBatch; ++i) {
    parts_[i] = {bytes_[i].data(), bytes_[i].size()};
    messages_[i].msg_hdr.msg_iov = &parts_[i];
    messages_[i].msg_hdr.msg_iovlen = 1;
    messages_[i].msg_hdr.msg_name = &peers_[i];
  }
}

int UdpBus::port() const { return bound_port(socket_); }

void UdpBus::step() {
  if (!socket_) {
    if (may_open()) listen();
    return;
  }
  pollfd poll{socket_.get(), POLLIN, 0};
  if (::poll(&poll, 1, kRound_ms) > 0) receive();
}

void UdpBus::listen() {
  try {
    socket_ = listen_udp({options_.host, options_.port});
    const int on = 1;
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on);
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer);
    opened();
    report_up();
  } catch (const DeviceError& error) {
    open_failed(error.what());
  }
}

void UdpBus::receive() {
  for (std::size_t i = 0; i < kBatch; ++i) {
    messages_[i].msg_hdr.msg_control = control_[i].data();
    messages_[i].msg_hdr.msg_controllen = control_[i].size();
    messages_[i].msg_hdr.msg_namelen = sizeof peers_[i];
  }
  const int got = ::recvmmsg(socket_.get(), messages_.data(), kBatch, MSG_DONTWAIT, nullptr);
  if (got < 0) return;
  const ArrivalClock clock;
  readings_.clear();
  for (int i = 0; i < got; ++i) {
    const auto slot = static_cast<std::size_t>(i);
    const double realtime_s = read_control(messages_[slot].msg_hdr);
    take(messages_[slot], slot, realtime_s, clock.monotonic_s(realtime_s));
  }
  if (!readings_.empty()) report(readings_);
}

double UdpBus::read_control(msghdr& header) {
  double realtime_s = 0;
  for (cmsghdr* c = CMSG_FIRSTHDR(&header); c != nullptr; c = CMSG_NXTHDR(&header, c)) {
    if (c->cmsg_level != SOL_SOCKET) continue;
    if (c->cmsg_type == SO_TIMESTAMPNS) {
      timespec t{};
      std::memcpy(&t, CMSG_DATA(c), sizeof t);
      realtime_s = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    } else if (c->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t total = 0;
      std::memcpy(&total, CMSG_DATA(c), sizeof total);
      dropped_.store(total, std::memory_order_relaxed);
    }
  }
  return realtime_s;
}

void UdpBus::take(const mmsghdr& message, std::size_t slot, double realtime_s, double time_s) {
  count(seen_);
  const std::string from = address_text(peers_[slot]);
  if (!allowed(address_bytes(peers_[slot]), options_.allow)) {
    count(rejected_);
    return warn("rejected", from + ": datagram rejected: not in an allowed network");
  }
  if ((message.msg_hdr.msg_flags & MSG_TRUNC) != 0) {
    count(bad_);
    return warn("too long",
                from + ": a datagram of more than " + std::to_string(kLongestDatagram) + " bytes");
  }
  const std::string_view text(bytes_[slot].data(), message.msg_len);
  if (tap_ != nullptr) {
    const Datagram datagram{std::string(text), realtime_s};
    tap_->traffic(&datagram, 1);
  }
  take_text(text, from, from + " " + std::to_string(port_of(peers_[slot])), time_s);
}

void UdpBus::take_text(std::string_view text, const std::string& from, const std::string& sender,
                       double time_s) {
  std::string problem;
  auto content = reader_.read(text, time_s, problem);
  if (!content) {
    count(bad_);
    return warn("bad", from + ": a datagram that is no JSON object of signals: " + problem);
  }
  if (content->unknown_count > 0) {
    warn("unknown",
         from + ": '" + content->unknown +
             "' is no signal that this [[udp]] takes, expected names of the rig's signals, or BOOM.SIGNAL");
  }
  if (content->sequence) {
    if (sequences_.size() >= kMostSenders && sequences_.count(sender) == 0) sequences_.clear();
    if (!sequences_[sender].passes(*content->sequence, time_s)) return count(late_);
  }
  if (content->readings.empty()) return;
  count(used_);
  readings_.insert(readings_.end(), content->readings.begin(), content->readings.end());
}

std::vector<BusCounter> UdpBus::counters() const {
  const auto read = [](const std::atomic<std::uint64_t>& x) { return x.load(std::memory_order_relaxed); };
  return {{"frames_seen", read(seen_)},         {"frames_used", read(used_)},
          {"frames_bad", read(bad_)},           {"frames_dropped", read(dropped_)},
          {"frames_rejected", read(rejected_)}, {"frames_late", read(late_)}};
}

std::unique_ptr<Bus> make_bus(const UdpOptions& options, BusListener& listener, UdpTap* tap) {
  return std::make_unique<UdpBus>(options, listener, tap);
}

}  // namespace rigsound::udp
