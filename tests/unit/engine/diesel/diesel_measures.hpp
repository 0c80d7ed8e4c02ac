// Figures of the run-time background that a test holds to a bound and the benchmark prints.
#pragma once

namespace rigsound::tests {

struct ResamplingError {
  double white_db = 0, engine_like_db = 0;  ///< error over signal; the second falls by 9 dB an octave
};
/// Angle samples (1024 a cycle, orders up to a quarter of that) read through a ramp of 600 to 2400 r/min in
/// 4 s, against the sum of the orders at every sample.
ResamplingError resampling_error();

struct TrackerError {
  double settled_cents = 0, ramp_cents = 0;  ///< rms
  double overshoot_cents = 0;
};
/// 20 ms messages of 0.125 r/min, 2 ms late: 600 r/min, a ramp of 900 r/min a second, 2400 r/min.
TrackerError tracker_error();

}  // namespace rigsound::tests
