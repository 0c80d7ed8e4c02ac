#include "bus_status.hpp"

#include "log.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::daemon {

using Lock = std::lock_guard<std::mutex>;

namespace {

constexpr std::int64_t kInterval_ms = 60'000;

}  // namespace

/// A driver's error names its device first, which whoever shows it has named already.
std::string BusStatus::without_name(const std::string& text) const {
  return text.rfind(name_ + ": ", 0) == 0 ? text.substr(name_.size() + 2) : text;
}

void BusStatus::up() {
  const Lock lock(mutex_);
  up_ = true;
  problem_.clear();
  ++changes_;
  log_change(monotonic_ms());
}

void BusStatus::down(const std::string& why) {
  const Lock lock(mutex_);
  up_ = false;
  problem_ = without_name(why);
  ++changes_;
  log_change(monotonic_ms());
}

void BusStatus::poll(std::int64_t now_ms) {
  const Lock lock(mutex_);
  log_change(now_ms);
}

void BusStatus::log_change(std::int64_t now_ms) {
  if (changes_ == 0 || now_ms < next_line_ms_) return;
  const std::string times = changes_ > 1 ? " (after " + std::to_string(changes_) + " changes)" : "";
  up_ ? log_info(name_ + ": up" + times) : log_warning(name_ + ": down: " + problem_ + times);
  changes_ = 0;
  next_line_ms_ = now_ms + kInterval_ms;
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
