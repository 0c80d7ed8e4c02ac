// Speed of the diesel between the messages of a bus.
#pragma once

namespace rigsound {

/// A speed and how it goes on. The slope holds for a while, then fades: a bus that fell silent says nothing.
struct SpeedTrend {
  double rpm = 0;    ///< r/min
  double slope = 0;  ///< r/min a second

  double at(double age_s) const noexcept;        ///< r/min, `age_s` >= 0 later; never negative
  double slope_at(double age_s) const noexcept;  ///< r/min a second
};

/// Alpha-beta tracker on message time stamps, critically damped. Messages of 20 ms and a ramp of 900 r/min a
/// second: 0.3 cents rms settled, 6 in the ramp. Thread: any, one at a time.
class RpmTracker {
 public:
  /// A message: `rpm` r/min was true at `time_s`. Times ascend. A jump too large for a flywheel is taken
  /// as it is, without a slope.
  void message(double time_s, double rpm) noexcept;

  /// The trend from `time_s` on, which is not before the last message.
  SpeedTrend at(double time_s) const noexcept;

 private:
  double time_ = -1e9, interval_ = 0.02;
  SpeedTrend trend_;
};

}  // namespace rigsound
