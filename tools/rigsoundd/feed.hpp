// One bus of the rig on its own thread, feeding the state.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "bus_status.hpp"
#include "rigsound/bus/bus.hpp"
#include "snapshot.hpp"
#include "state_exchange.hpp"

namespace rigsound::daemon {

/// Runs from construction to stop(). Destruction waits for the end of the bus's thread.
class Feed : private BusListener {
 public:
  using MakeBus = std::function<std::unique_ptr<Bus>(BusListener&)>;

  /// `bus_text`: what the bus was told, config::bus_text().
  Feed(const MakeBus& make, StateExchange& exchange, std::string bus_text = {});
  ~Feed() override;
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

  void stop() noexcept { bus_->stop(); }  ///< Thread: CT
  /// The bus's thread is over: destruction does not wait. Thread: CT
  bool ended() const noexcept { return ended_.load(std::memory_order_acquire); }

  BusSnapshot snapshot() const;  ///< Thread: CT
  const std::string& bus_text() const { return bus_text_; }

 private:
  void run();
  void readings(const Reading* first, std::size_t count) override;
  void up() override { status_.up(); }
  void down(const std::string& why) override { status_.down(why); }
  void notice(const std::string& text) override { status_.notice(text); }

  StateExchange& exchange_;
  std::string bus_text_;
  std::unique_ptr<Bus> bus_;
  BusStatus status_;
  std::atomic<bool> ended_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace rigsound::daemon
