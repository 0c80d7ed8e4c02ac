#include "bus_status.hpp"

#include <spdlog/spdlog.h>

namespace rigsound::daemon {

using Lock = std::lock_guard<std::mutex>;

void BusStatus::up() {
  const Lock lock(mutex_);
  up_ = true;
  problem_.clear();
  spdlog::info("{}: up", name_);
}

void BusStatus::down(const std::string& why) {
  const Lock lock(mutex_);
  up_ = false;
  problem_ = why;
  spdlog::warn("{}: down: {}", name_, why);
}

void BusStatus::notice(const std::string& text) {
  const Lock lock(mutex_);
  if (!up_) problem_ = text;
  spdlog::warn("{}: {}", name_, text);
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
