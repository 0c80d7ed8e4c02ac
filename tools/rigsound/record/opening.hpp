// Whether a bus could be opened when a recording began.
#pragma once

#include <atomic>
#include <future>
#include <string>

#include "rigsound/device_error.hpp"

namespace rigsound::tools {

/// The first word of a bus, from its own thread: it works, or why it does not. Later words are no matter of
/// this.
class Opening {
 public:
  void worked() {
    if (!said_.exchange(true)) word_.set_value({});
  }
  /// Returns false when this was not the first word.
  bool failed(const std::string& why) {
    if (said_.exchange(true)) return false;
    word_.set_value(why);
    return true;
  }

  /// Waits for the first word. Errors: DeviceError. Thread: OFF, once.
  void require() {
    const std::string why = word_.get_future().get();
    if (!why.empty()) throw DeviceError(why);
  }

 private:
  std::atomic<bool> said_{false};
  std::promise<std::string> word_;
};

}  // namespace rigsound::tools
