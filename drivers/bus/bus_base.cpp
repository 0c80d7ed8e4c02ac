#include "bus/bus_base.hpp"

#include <algorithm>

#include "rigsound/monotonic_time.hpp"

namespace rigsound {

BusBase::BusBase(std::string name, std::vector<SignalId> signals, BusListener& listener)
    : name_(std::move(name)),
      signals_(std::move(signals)),
      listener_(listener),
      warnings_([this](const std::string& text) { listener_.notice(text); }) {}

void BusBase::report(const std::vector<Reading>& readings) {
  listener_.readings(readings.data(), readings.size());
}

void BusBase::report_all(Validity validity) {
  const double now_s = monotonic_s();
  std::vector<Reading> unknown;
  for (const SignalId id : signals_) unknown.push_back({id, 0, validity, now_s});
  report(unknown);
}

void BusBase::report_up() {
  problem_.clear();
  if (lost_) report_all(Validity::kStale);
  lost_ = false;
  listener_.up();
}

void BusBase::report_down(const std::string& why) {
  problem_ = why;
  lost_ = true;
  report_all(Validity::kBusDown);
  listener_.down(why);
}

void BusBase::report_problem(const std::string& why) {
  if (problem_ == why) return;
  problem_ = why;
  listener_.notice(why);
}

void BusBase::warn(const std::string& kind, const std::string& text) {
  warnings_.add(kind, text, monotonic_ms());
}

bool BusBase::may_open() const {
  const std::int64_t left_ms = backoff_.left_ms(monotonic_ms());
  if (left_ms == 0) return true;
  stop_event().wait(-1, 0, static_cast<int>(std::min<std::int64_t>(left_ms, kRound_ms)));
  return false;
}

void BusBase::opened() { backoff_.worked(monotonic_ms()); }

std::int64_t BusBase::open_failed(const std::string& why) {
  const std::int64_t now_ms = monotonic_ms();
  backoff_.failed(now_ms);
  report_problem(why);
  return backoff_.left_ms(now_ms);
}

void BusBase::pause_before_reopening() { backoff_.failed(monotonic_ms()); }

}  // namespace rigsound
