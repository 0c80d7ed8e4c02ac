#include "exposure.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::daemon {
namespace {

constexpr double kDay_s = 8 * 3600;     // of work
constexpr double kMinute_s = 60;        // time constant of the average that the limit is held against
constexpr double kSpread_s = 5;         // in which what the average has left may be used up
constexpr double kTarget = 0.70794578;  // of the limit: -1.5 dB, for what comes before the gain has followed
constexpr double kSourceFalls_s = 2;    // a source that pauses between two blows is still there
constexpr double kRiseDb_per_s = 1;     // of the gain
constexpr double kLeastGain = 1e-3;
constexpr double kPeakOfSine = 2;  // its power over that of its rms, which the calibration is of

double power_of_db(double db) { return std::pow(10, db / 10); }

}  // namespace

void Exposure::set(double db_spl_at_0dbfs, double max_laeq_db) {
  calibration_db_ = db_spl_at_0dbfs;
  limit_ = max_laeq_db > 0 ? power_of_db(max_laeq_db - db_spl_at_0dbfs) : 0;
  if (limit_ == 0) gain_ = earlier_[0] = earlier_[1] = 1;
}

void Exposure::take(const LevelWindow& window, double block_s) {
  if (window.blocks == 0) return;
  const double blocks = static_cast<double>(window.blocks), seconds = blocks * block_s;
  const double power = window.sound.power / blocks;
  energy_ += power * seconds;
  seconds_ += seconds;
  peak_ = std::max(peak_, window.sound.c_peak);
  fast_ = window.sound.fast, slow_ = window.sound.slow;
  minute_ = power + (minute_ - power) * std::exp(-seconds / kMinute_s);
  if (limit_ > 0) limit(power, seconds);
}

void Exposure::limit(double power, double seconds) {
  const double heard = std::max({gain_, earlier_[0], earlier_[1]});  // while the window lasted, or less
  source_ = std::max(power / (heard * heard), source_ * std::exp(-seconds / kSourceFalls_s));
  const double target = kTarget * limit_;
  const double allowed = std::max(0.0, target + (target - minute_) * (kMinute_s / kSpread_s));
  const double wanted = source_ > allowed ? std::sqrt(allowed / source_) : 1.0;
  earlier_[1] = earlier_[0], earlier_[0] = gain_;
  gain_ = std::max(kLeastGain, std::min(wanted, gain_ * std::pow(10, kRiseDb_per_s * seconds / 20)));
  gain_ = std::min(1.0, gain_);
}

void Exposure::reset() { energy_ = peak_ = seconds_ = 0; }

double Exposure::db(double power) const {
  return power > 0 ? std::max(0.0, 10 * std::log10(power) + calibration_db_) : 0;
}

std::optional<ExposureSnapshot> Exposure::snapshot() const {
  if (calibration_db_ == 0) return {};
  ExposureSnapshot s;
  s.fast_db = db(fast_);
  s.slow_db = db(slow_);
  s.minute_db = db(minute_);
  s.day_db = db(energy_ / kDay_s);
  s.peak_db = db(kPeakOfSine * peak_ * peak_);
  s.since_s = seconds_;
  s.turned_down_db = gain_ < 1 ? -20 * std::log10(gain_) : 0;
  return s;
}

}  // namespace rigsound::daemon
