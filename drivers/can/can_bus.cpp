#include "can/can_bus.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "bus/arrival_clock.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::can {
namespace {

constexpr std::size_t kBatch = 256;

CanSocketOptions socket_options(const CanOptions& options, const CanTap* tap) {
  CanSocketOptions socket;
  socket.interface = options.interface;
  socket.fd = options.fd;
  socket.everything = tap != nullptr;
  for (const SignalRoute& route : options.routes) socket.wanted.push_back(route.match);
  return socket;
}

}  // namespace

CanBus::CanBus(const CanOptions& options, BusListener& listener, CanTap* tap, std::unique_ptr<CanPort> port)
    : BusBase("can " + options.interface, targets(options.routes), listener),
      options_(socket_options(options, tap)),
      decoder_(options.routes),
      sources_(options.routes),
      tap_(tap),
      port_(std::move(port)),
      batch_(kBatch) {}

void CanBus::step() {
  if (!socket_) return open();
  const int got = socket_->receive(batch_.data(), batch_.size(), kRound_ms, stop_event());
  dropped_.store(dropped_before_ + socket_->dropped(), std::memory_order_relaxed);
  if (got > 0) return dispatch(batch_.data(), got);
  if (got < 0) lose(options_.interface + ": " + std::strerror(-got));
}

void CanBus::open() {
  try {
    socket_ = port_->open(options_);
    opened();
    bus_off_ = false;
    report_up();
  } catch (const DeviceError& error) {
    port_->wait_for_change(static_cast<int>(open_failed(error.what())), stop_event());
  }
}

void CanBus::lose(const std::string& why) {
  dropped_before_ = dropped_.load(std::memory_order_relaxed);
  socket_.reset();
  lost_.fetch_add(1, std::memory_order_relaxed);
  report_down(why);
}

// Runs of data frames are decoded in one piece; error frames come singly between them.
void CanBus::dispatch(const Arrival* first, std::size_t count) {
  const Arrival* const end = first + count;
  const auto is_error = [](const Arrival& a) { return a.frame.error; };
  while (first != end) {
    const Arrival* const error = std::find_if(first, end, is_error);
    if (error != first) data_frames(first, error - first);
    if (error == end) return;
    error_frames_.fetch_add(1, std::memory_order_relaxed);
    controller_error(error->frame);
    first = error + 1;
  }
}

void CanBus::data_frames(const Arrival* first, std::size_t count) {
  frames_.fetch_add(count, std::memory_order_relaxed);
  if (tap_ != nullptr) tap_->traffic(first, count);
  const ArrivalClock clock;
  readings_.clear();
  std::uint64_t used = 0;
  for (const Arrival* a = first; a != first + count; ++a) {
    if (!decoder_.decode(a->frame, clock.monotonic_s(a->realtime_s), readings_)) continue;
    ++used;
    if (const auto several = sources_.add(a->frame)) warn("sources", *several);
  }
  report(readings_);
  used_.fetch_add(used, std::memory_order_relaxed);
}

void CanBus::controller_error(const Frame& frame) {
  if ((frame.id & CAN_ERR_BUSOFF) != 0 && !bus_off_) {
    bus_off_ = true;
    report_down(options_.interface +
                ": the controller is bus-off; it returns by itself only with `ip link set " +
                options_.interface + " type can restart-ms 100`");
  }
  if ((frame.id & CAN_ERR_RESTARTED) != 0 && bus_off_) {
    bus_off_ = false;
    report_up();
  }
  const bool passive = (frame.data[1] & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0;
  if ((frame.id & CAN_ERR_CRTL) != 0 && passive)
    warn("error-passive",
         options_.interface + ": the controller is error-passive: look at wiring, termination, bit rate");
}

std::vector<BusCounter> CanBus::counters() const {
  const auto read = [](const std::atomic<std::uint64_t>& x) { return x.load(std::memory_order_relaxed); };
  return {{"frames_seen", read(frames_)},
          {"frames_used", read(used_)},
          {"frames_bad", read(error_frames_)},
          {"frames_dropped", read(dropped_)},
          {"losses", read(lost_)}};
}

std::unique_ptr<Bus> make_bus(const CanOptions& options, BusListener& listener, CanTap* tap) {
  return std::make_unique<CanBus>(options, listener, tap, kernel_can_port());
}

}  // namespace rigsound::can
