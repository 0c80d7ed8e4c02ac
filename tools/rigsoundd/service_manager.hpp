// What systemd wants to hear; silent when nobody listens.
#pragma once

#include <cstdint>
#include <string>

namespace rigsound::daemon {

/// Thread: CT.
class ServiceManager {
 public:
  ServiceManager();

  void ready() const;
  void reloading() const;
  void stopping() const;
  void status(const std::string& text);  ///< sent only when it changed

  /// Feeds the watchdog at half its time, but only when `progress` has grown since the last feed.
  void watch(std::uint64_t progress, double now_s);

 private:
  double feed_every_s_ = 0;  // 0: no watchdog
  double next_feed_s_ = 0;
  std::uint64_t last_progress_ = 0;
  std::string last_status_;
};

}  // namespace rigsound::daemon
