// All-pole models: Levinson's recursion, and the same body at another sampling rate.
#pragma once

#include <vector>

namespace rigsound::dsp {

struct LinearPrediction {
  std::vector<double> a;  ///< a[0] = 1 ... a[p]: A(z) = sum a[k] z^-k
  double error = 0;       ///< prediction error power relative to r[0]
};

/// Solves the normal equations for the autocorrelation r[0...p]. Needs r[0] > 0. Thread: OFF.
LinearPrediction levinson(const std::vector<double>& r);

/// 1/A(z) of `rate_from` as a filter of the same order at `rate_to`: the power response in Hz is kept, over
/// the old Nyquist frequency it stays at its last value. Thread: OFF.
std::vector<double> all_pole_at_rate(const std::vector<double>& a, double rate_from, double rate_to);

}  // namespace rigsound::dsp
