#include <algorithm>
#include <chrono>
#include <thread>

#include "bus_log.hpp"
#include "feed.hpp"
#include "rigsound/can/can_bus.hpp"
#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {
namespace {

can::CanBusOptions bus_options(const can::CanOptions& options) {
  can::CanBusOptions bus;
  bus.interface = options.interface;
  bus.fd = options.fd;
  for (const can::SignalRoute& route : options.routes) bus.wanted.push_back(route.match);
  return bus;
}

// The kernel stamps with the time of day; the board counts from the machine's start.
double arrival_s(const can::Arrival& arrival, double realtime_s, double now_s) {
  const double age_s = arrival.realtime_s > 0 ? realtime_s - arrival.realtime_s : 0;
  return now_s - std::clamp(age_s, 0.0, 1.0);
}

class CanFeed : public Feed, private can::CanListener {
 public:
  CanFeed(const can::CanOptions& options, StateExchange& exchange)
      : exchange_(exchange),
        decoder_(options.routes),
        log_("can " + options.interface),
        bus_(bus_options(options), *this),
        thread_([this] { bus_.run(stop_); }) {}

  ~CanFeed() override {
    stop_ = true;
    thread_.join();
  }

  FeedStatus status() const override {
    const can::CanCounters c = bus_.counters();
    return {log_.name(),
            log_.is_up(),
            log_.last_problem(),
            {{"frames_seen", c.frames},
             {"frames_used", used_.load(std::memory_order_relaxed)},
             {"frames_bad", c.error_frames},
             {"frames_dropped", c.dropped},
             {"losses", c.lost}}};
  }

 private:
  void frames(const can::Arrival* first, std::size_t count) override {
    const double realtime_s =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    const double now_s = monotonic_s();
    std::uint64_t used = 0;
    readings_.clear();
    for (std::size_t i = 0; i < count; ++i)
      used += decoder_.decode(first[i].frame, arrival_s(first[i], realtime_s, now_s), readings_) ? 1 : 0;
    exchange_.change([&](SignalBoard& board) {
      for (const Reading& reading : readings_) board.take(reading);
    });
    used_.fetch_add(used, std::memory_order_relaxed);
  }
  void up() override { log_.up(); }
  void down(const std::string& why) override {
    log_.down(why);
    exchange_.change([this](SignalBoard& board) {
      for (const can::SignalRoute& route : decoder_.routes())
        board.take({route.target, 0, Validity::kBusDown, 0});
    });
  }
  void notice(const std::string& text) override { log_.notice(text); }

  StateExchange& exchange_;
  can::FrameDecoder decoder_;
  std::vector<Reading> readings_;
  BusLog log_;
  can::CanBus bus_;
  std::atomic<std::uint64_t> used_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace

std::unique_ptr<Feed> make_feed(const can::CanOptions& options, StateExchange& exchange) {
  return std::make_unique<CanFeed>(options, exchange);
}

}  // namespace rigsound::daemon
