// From time to crank angle and back: windowed-sinc interpolation at moving positions.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// How an interpolation cuts: number of taps, Kaiser's beta, share of half the rate to keep (0...1).
struct Sinc {
  int taps = 64;
  double beta = 12;
  double bandwidth = 0.92;
};
constexpr Sinc kQuickSinc{16, 8, 1};  ///< for content below a quarter of the rate

/// `x` at fractional sample positions, zeros outside. Thread: OFF.
std::vector<double> interpolated(const std::vector<double>& x, const std::vector<double>& positions,
                                 const Sinc& sinc = {});

/// Where a rising `theta` (cycles, one value a sample) passes first + j / per_cycle, j = 0 ... count - 1, as
/// fractional samples. Thread: OFF.
std::vector<double> samples_at_angles(const std::vector<double>& theta, double first, int per_cycle,
                                      std::size_t count);

/// Forward and backward through the engine's sixth-order Butterworth: no phase, -6 dB at `frequency_hz`.
/// Thread: OFF.
std::vector<double> zero_phase_high_pass(const std::vector<double>& x, double frequency_hz, double rate);
std::vector<double> zero_phase_low_pass(const std::vector<double>& x, double frequency_hz, double rate);

/// Every `factor`-th value after a linear-phase low-pass at 0.45 of the new rate. Thread: OFF.
std::vector<double> decimated(const std::vector<double>& x, int factor);

}  // namespace rigsound::analysis
