#include "bus_status.hpp"

#include "log.hpp"

namespace rigsound::daemon {

using Lock = std::lock_guard<std::mutex>;

/// A driver's error names its device first, which whoever shows it has named already.
std::string BusStatus::without_name(const std::string& text) const {
  return text.rfind(name_ + ": ", 0) == 0 ? text.substr(name_.size() + 2) : text;
}

void BusStatus::up() {
  const Lock lock(mutex_);
  up_ = true;
  problem_.clear();
  log_info(name_ + ": up");
}

void BusStatus::down(const std::string& why) {
  const Lock lock(mutex_);
  up_ = false;
  problem_ = without_name(why);
  log_warning(name_ + ": down: " + problem_);
}

void BusStatus::notice(const std::string& text) {
  const Lock lock(mutex_);
  if (!up_) problem_ = without_name(text);
  log_warning(name_ + ": " + without_name(text));
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
