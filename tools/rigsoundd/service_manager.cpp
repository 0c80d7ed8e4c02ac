#include "service_manager.hpp"

#include <systemd/sd-daemon.h>

namespace rigsound::daemon {

ServiceManager::ServiceManager() {
  std::uint64_t watchdog_us = 0;
  if (::sd_watchdog_enabled(0, &watchdog_us) > 0) feed_every_s_ = static_cast<double>(watchdog_us) * 0.5e-6;
}

void ServiceManager::ready() const { ::sd_notify(0, "READY=1"); }
void ServiceManager::reloading() const { ::sd_notify(0, "RELOADING=1"); }
void ServiceManager::stopping() const { ::sd_notify(0, "STOPPING=1"); }

void ServiceManager::status(const std::string& text) {
  if (text == last_status_) return;
  last_status_ = text;
  ::sd_notify(0, ("STATUS=" + text).c_str());
}

void ServiceManager::watch(std::uint64_t progress, double now_s) {
  if (feed_every_s_ <= 0 || now_s < next_feed_s_ || progress == last_progress_) return;
  ::sd_notify(0, "WATCHDOG=1");
  last_progress_ = progress;
  next_feed_s_ = now_s + feed_every_s_;
}

}  // namespace rigsound::daemon
