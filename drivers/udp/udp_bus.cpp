#include "udp/udp_bus.hpp"

namespace rigsound::udp {
namespace {

constexpr std::size_t kMostSenders = 64;  // whose numbers are kept

}  // namespace

UdpBus::UdpBus(const UdpOptions& options, BusListener& listener, UdpTap* tap)
    : DatagramBus("udp " + options.address, targets(options.routes),
                  {options.host, options.port, options.allow}, listener),
      tap_(tap),
      reader_(options.routes) {}

void UdpBus::take(const Arrival& arrival) {
  if (tap_ != nullptr) {
    const Datagram datagram{std::string(arrival.bytes), arrival.realtime_s};
    tap_->traffic(&datagram, 1);
  }
  std::string problem;
  const auto content = reader_.read(arrival.bytes, arrival.time_s, problem);
  if (!content) {
    count(bad_);
    return warn("bad", arrival.host + ": a datagram that is no JSON object of signals: " + problem);
  }
  if (content->unknown_count > 0) {
    warn("unknown",
         arrival.host + ": '" + content->unknown +
             "' is no signal that this [[udp]] takes, expected names of the rig's signals, or BOOM.SIGNAL");
  }
  if (content->sequence) {
    const std::string sender = arrival.host + " " + std::to_string(arrival.port);
    if (sequences_.size() >= kMostSenders && sequences_.count(sender) == 0) sequences_.clear();
    if (!sequences_[sender].passes(*content->sequence, arrival.time_s)) return count(late_);
  }
  if (content->readings.empty()) return;
  count(used_);
  for (const Reading& reading : content->readings) deliver(reading);
}

std::unique_ptr<Bus> make_bus(const UdpOptions& options, BusListener& listener, UdpTap* tap) {
  return std::make_unique<UdpBus>(options, listener, tap);
}

}  // namespace rigsound::udp
