#include "feed.hpp"

#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {

Feed::Feed(const MakeBus& make, StateExchange& exchange, std::string bus_text)
    : exchange_(exchange),
      bus_text_(std::move(bus_text)),
      bus_(make(*this)),
      status_(bus_->name()),
      thread_([this] { run(); }) {}

void Feed::run() {
  while (!bus_->stopped()) {
    bus_->step();
    status_.poll(monotonic_ms());
  }
  ended_.store(true, std::memory_order_release);
}

Feed::~Feed() {
  stop();
  thread_.join();
}

BusSnapshot Feed::snapshot() const {
  return {bus_->name(), status_.is_up(), status_.last_problem(), bus_->counters()};
}

void Feed::readings(const Reading* first, std::size_t count) {
  if (count == 0) return;
  exchange_.change([&](SignalBoard& board) {
    for (const Reading* reading = first; reading != first + count; ++reading) board.take(*reading);
  });
}

}  // namespace rigsound::daemon
