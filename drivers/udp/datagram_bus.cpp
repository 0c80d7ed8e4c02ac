#include "udp/datagram_bus.hpp"

#include <netinet/in.h>

#include <cmath>
#include <utility>

#include "bus/arrival_clock.hpp"
#include "bus/kernel_note.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/socket/tcp_listener.hpp"

namespace rigsound::udp {
namespace {

constexpr int kReceiveBuffer = 4 << 20;  // bytes

/// The port lies alike in sockaddr_in6.
int port_of(const sockaddr_storage& peer) {
  return ntohs(reinterpret_cast<const sockaddr_in&>(peer).sin_port);
}

}  // namespace

DatagramBus::DatagramBus(std::string name, std::vector<SignalId> signals, Port port, BusListener& listener)
    : BusBase(std::move(name), std::move(signals), listener), port_(std::move(port)), bytes_(kBatch) {
  for (std::size_t i = 0; i < kBatch; ++i) {
    parts_[i] = {bytes_[i].data(), bytes_[i].size()};
    messages_[i].msg_hdr.msg_iov = &parts_[i];
    messages_[i].msg_hdr.msg_iovlen = 1;
    messages_[i].msg_hdr.msg_name = &peers_[i];
  }
}

int DatagramBus::port() const { return bound_port(socket_); }

void DatagramBus::step() {
  if (!socket_) {
    if (may_open()) listen();
    return;
  }
  const bool some = stop_event().wait(socket_.get(), POLLIN, static_cast<int>(std::ceil(wait_s_ * 1e3)));
  readings_.clear();
  if (some) receive();
  wait_s_ = after_round();
  if (!readings_.empty()) report(readings_);
}

void DatagramBus::listen() {
  try {
    socket_ = listen_udp({port_.host, port_.port}, stop_event());
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

void DatagramBus::receive() {
  for (std::size_t i = 0; i < kBatch; ++i) {
    messages_[i].msg_hdr.msg_control = control_[i].data();
    messages_[i].msg_hdr.msg_controllen = control_[i].size();
    messages_[i].msg_hdr.msg_namelen = sizeof peers_[i];
  }
  const int got = ::recvmmsg(socket_.get(), messages_.data(), kBatch, MSG_DONTWAIT, nullptr);
  const ArrivalClock clock;
  for (int i = 0; i < got; ++i) {
    const auto slot = static_cast<std::size_t>(i);
    const KernelNote note = kernel_note(messages_[slot].msg_hdr);
    if (note.dropped) dropped_.store(*note.dropped, std::memory_order_relaxed);
    sift(messages_[slot], slot, note.realtime_s, clock.monotonic_s(note.realtime_s));
  }
}

void DatagramBus::sift(const mmsghdr& message, std::size_t slot, double realtime_s, double time_s) {
  count(seen_);
  const std::string from = address_text(peers_[slot]);
  if (!allowed(address_bytes(peers_[slot]), port_.allow)) {
    count(rejected_);
    return warn("rejected", from + ": datagram rejected: not in an allowed network");
  }
  if ((message.msg_hdr.msg_flags & MSG_TRUNC) != 0) {
    count(bad_);
    return warn("too long",
                from + ": a datagram of more than " + std::to_string(kLongestDatagram) + " bytes");
  }
  take({{bytes_[slot].data(), message.msg_len}, from, port_of(peers_[slot]), realtime_s, time_s});
}

std::vector<BusCounter> DatagramBus::counters() const {
  const auto read = [](const std::atomic<std::uint64_t>& x) { return x.load(std::memory_order_relaxed); };
  return {{"frames_seen", read(seen_)},         {"frames_used", read(used_)},
          {"frames_bad", read(bad_)},           {"frames_dropped", read(dropped_)},
          {"frames_rejected", read(rejected_)}, {"frames_late", read(late_)}};
}

}  // namespace rigsound::udp
