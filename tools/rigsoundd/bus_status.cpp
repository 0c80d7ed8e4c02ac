#include "bus_status.hpp"

#include "log.hpp"

namespace rigsound::daemon {

using Lock = std::lock_guard<std::mutex>;

void BusStatus::up() {
  const Lock lock(mutex_);
  up_ = true;
  problem_.clear();
  log_info(name_ + ": up");
}

void BusStatus::down(const std::string& why) {
  const Lock lock(mutex_);
  up_ = false;
  problem_ = why;
  log_warning(name_ + ": down: " + why);
}

void BusStatus::notice(const std::string& text) {
  const Lock lock(mutex_);
  if (!up_) problem_ = text;
  log_warning(name_ + ": " + text);
}

bool BusStatus::is_up() const {
  const Lock lock(mutex_);
  return up_;
}

std::string BusStatus::last_problem() const {
  const Lock lock(mutex_);
  return problem_;
}

}  // namespace rigsound::daemon
