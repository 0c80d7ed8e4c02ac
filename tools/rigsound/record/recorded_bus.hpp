// One bus on its own thread while it is recorded, with what it says of itself.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <thread>

#include "rigsound/bus/bus.hpp"

namespace rigsound::tools {

/// News go to stderr, from the bus's own thread; but the first, when it is bad, is left to require_up(). Runs
/// from construction to destruction, which prints the counters.
class RecordedBus : private BusListener {
 public:
  explicit RecordedBus(const std::function<std::unique_ptr<Bus>(BusListener&)>& make);
  ~RecordedBus() override;
  RecordedBus(const RecordedBus&) = delete;
  RecordedBus& operator=(const RecordedBus&) = delete;

  /// Waits for the first news. Errors: DeviceError when the bus is not up. Thread: OFF, once.
  void require_up();

 private:
  void readings(const Reading*, std::size_t) override {}
  void up() override;
  void down(const std::string& why) override;
  void notice(const std::string& text) override;

  std::unique_ptr<Bus> bus_;
  std::atomic<bool> told_{false};
  std::promise<std::string> first_problem_;  // empty: none
  std::thread thread_;                       // last: it uses all of the above
};

}  // namespace rigsound::tools
