#include "rigsound/machine/rpm_tracker.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound {
namespace {

constexpr double kFast_rad_s = 50, kFastInterval_s = 0.02;  // bandwidth for 20 ms messages
constexpr double kSlow_rad_s = 25, kSlowInterval_s = 0.1;   // and for 100 ms
constexpr double kJump = 0.12;  // relative step that no flywheel makes between two messages
constexpr double kTrusted_s = 0.25, kFade_s = 0.1;  // age until which the slope holds, and its decay after
constexpr double kLongest_s = 0.25;

double bandwidth(double interval_s) noexcept {
  const double share = (interval_s - kFastInterval_s) / (kSlowInterval_s - kFastInterval_s);
  return kFast_rad_s + (kSlow_rad_s - kFast_rad_s) * std::clamp(share, 0.0, 1.0);
}

}  // namespace

double SpeedTrend::at(double age_s) const noexcept {
  if (slope == 0) return std::max(0.0, rpm);
  const double trusted = std::min(age_s, kTrusted_s);
  const double faded = age_s > kTrusted_s ? kFade_s * (1 - dsp::exp((kTrusted_s - age_s) / kFade_s)) : 0.0;
  return std::max(0.0, rpm + slope * (trusted + faded));
}

double SpeedTrend::slope_at(double age_s) const noexcept {
  return age_s > kTrusted_s ? slope * dsp::exp((kTrusted_s - age_s) / kFade_s) : slope;
}

void RpmTracker::message(double time_s, double rpm) noexcept {
  const double dt = time_s - time_;
  if (!(dt > 0)) return;
  const double predicted = trend_.at(dt);
  const double error = rpm - predicted;
  time_ = time_s;
  if (std::fabs(error) > kJump * std::max(predicted, rpm) || dt > 4 * kLongest_s) {
    trend_ = {rpm, 0};
    return;
  }
  interval_ += 0.25 * (std::min(dt, kLongest_s) - interval_);
  const double rho = dsp::exp(-bandwidth(interval_) * dt);
  trend_.rpm = predicted + (1 - rho * rho) * error;
  trend_.slope += (1 - rho) * (1 - rho) / dt * error;
}

SpeedTrend RpmTracker::at(double time_s) const noexcept {
  const double age_s = std::max(0.0, time_s - time_);
  return {trend_.at(age_s), trend_.slope_at(age_s)};
}

}  // namespace rigsound
