#include "rigsound/can/can_bus.hpp"

#include <linux/can.h>
#include <linux/can/error.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "can/can_port.hpp"
#include "complaints.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::can {
namespace {

constexpr int kRound_ms = 200;
constexpr int kFirstPause_ms = 100, kLongestPause_ms = 5000;
constexpr std::size_t kBatch = 256;

}  // namespace

CanBus::CanBus(CanBusOptions options, CanListener& listener)
    : CanBus(std::move(options), listener, kernel_can_port()) {}

CanBus::CanBus(CanBusOptions options, CanListener& listener, std::unique_ptr<CanPort> port)
    : options_(std::move(options)),
      listener_(listener),
      port_(std::move(port)),
      complaints_(std::make_unique<Complaints>([this](const std::string& text) { listener_.notice(text); })),
      batch_(kBatch),
      pause_ms_(kFirstPause_ms) {}

CanBus::~CanBus() = default;

void CanBus::run(const std::atomic<bool>& stop) {
  while (!stop.load(std::memory_order_relaxed)) step();
}

void CanBus::step() {
  if (!link_) return look_for_interface();
  const int got = link_->receive(batch_.data(), batch_.size(), kRound_ms);
  dropped_.store(dropped_before_ + link_->dropped(), std::memory_order_relaxed);
  if (got > 0) return sort(batch_.data(), static_cast<std::size_t>(got));
  if (got < 0) lose(options_.interface + ": " + std::strerror(-got));
}

void CanBus::look_for_interface() {
  try {
    link_ = port_->open(options_);
    pause_ms_ = kFirstPause_ms;
    last_problem_.clear();
    bus_off_ = false;
    listener_.up();
  } catch (const DeviceError& error) {
    if (last_problem_ != error.what()) listener_.notice(error.what());
    last_problem_ = error.what();
    port_->wait_for_change(pause_ms_);
    pause_ms_ = std::min(2 * pause_ms_, kLongestPause_ms);
  }
}

void CanBus::lose(const std::string& why) {
  dropped_before_ = dropped_.load(std::memory_order_relaxed);
  link_.reset();
  lost_.fetch_add(1, std::memory_order_relaxed);
  listener_.down(why);
}

// Runs of data frames go to the listener in one piece; error frames come singly between them.
void CanBus::sort(const Arrival* first, std::size_t count) {
  const Arrival* const end = first + count;
  const auto is_error = [](const Arrival& a) { return a.frame.error; };
  while (first != end) {
    const Arrival* const error = std::find_if(first, end, is_error);
    if (error != first) {
      frames_.fetch_add(static_cast<std::uint64_t>(error - first), std::memory_order_relaxed);
      listener_.frames(first, static_cast<std::size_t>(error - first));
    }
    if (error == end) return;
    error_frames_.fetch_add(1, std::memory_order_relaxed);
    controller_error(error->frame);
    first = error + 1;
  }
}

void CanBus::controller_error(const Frame& frame) {
  if ((frame.id & CAN_ERR_BUSOFF) != 0 && !bus_off_) {
    bus_off_ = true;
    listener_.down(options_.interface +
                   ": the controller is bus-off; it returns by itself only with `ip link set " +
                   options_.interface + " type can restart-ms 100`");
  }
  if ((frame.id & CAN_ERR_RESTARTED) != 0 && bus_off_) {
    bus_off_ = false;
    listener_.up();
  }
  const bool passive = (frame.data[1] & (CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE)) != 0;
  if ((frame.id & CAN_ERR_CRTL) != 0 && passive)
    complaints_->add(options_.interface +
                     ": the controller is error-passive: look at wiring, termination, bit rate");
}

CanCounters CanBus::counters() const noexcept {
  CanCounters c;
  c.frames = frames_.load(std::memory_order_relaxed);
  c.error_frames = error_frames_.load(std::memory_order_relaxed);
  c.dropped = dropped_.load(std::memory_order_relaxed);
  c.lost = lost_.load(std::memory_order_relaxed);
  return c;
}

}  // namespace rigsound::can
