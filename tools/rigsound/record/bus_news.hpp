// What a bus says of itself while it is recorded.
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <future>
#include <string>
#include <utility>

#include "rigsound/device_error.hpp"

namespace rigsound::tools {

/// Printed to stderr, from the bus's own thread; but the first word, when it is bad, is left to require_up().
class BusNews {
 public:
  explicit BusNews(std::string bus) : bus_(std::move(bus)) {}

  void up() {
    fmt::print(stderr, "{}: recording\n", bus_);
    if (!said_.exchange(true)) first_word_.set_value({});
  }
  void down(const std::string& why) { fmt::print(stderr, "{}: down: {}\n", bus_, why); }
  void notice(const std::string& text) {
    if (said_.exchange(true)) return fmt::print(stderr, "{}\n", text);
    first_word_.set_value(text);
  }

  /// Waits for the first word. Errors: DeviceError when the bus is not up. Thread: OFF, once.
  void require_up() {
    const std::string problem = first_word_.get_future().get();
    if (!problem.empty()) throw DeviceError(problem);
  }

  const std::string& bus() const { return bus_; }

 private:
  std::string bus_;
  std::atomic<bool> said_{false};
  std::promise<std::string> first_word_;
};

}  // namespace rigsound::tools
