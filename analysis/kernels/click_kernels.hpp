// The inner loops of steps 2 and 5, whitening and the variance model, compiled once per instruction set and
// chosen at run time. The order of every addition is written down and nothing is fused, so every instruction
// set gives the same bits: sums run in eight partial ones, then those; what is left of the length comes after
// them, or in weigh() fills its lanes up with nothing.
#pragma once

namespace rigsound::analysis {

struct PairOfSums {
  double first = 0, second = 0;
};

/// Of one stretch: x = min(q / v, clip) / v and y = 1 / v.
struct WeighedSums {
  double x = 0, y = 0;    ///< sum x, sum y
  double ax = 0, ay = 0;  ///< sum a x, sum a y
};

struct ClickKernels {
  const char* name;  ///< instruction set, for reports

  /// y(n) = sum over k < taps of A(k) x(n - k), n = 0 ... size - 1; x(-taps + 1) is the first that is read.
  void (*filter)(const float* x, long size, const float* A, int taps, float* y);

  /// v = floor + carried decay.
  void (*tail)(double carried, const double* decay, double floor, long size, double* v);

  /// v over 1e-150. What a multiplicative update of the power of a^2 needs, in one pass.
  WeighedSums (*weigh)(const double* q, const double* v, const double* a, double clip, long size);

  /// sum a x, sum a y.
  PairOfSums (*products)(const double* a, const double* x, const double* y, long size);

  /// sum ln v, v over 1e-150, and sum min(q / v, clip).
  PairOfSums (*divergence)(const double* q, const double* v, double clip, long size);
};

/// The kernels for the best instruction set of this machine. Thread: OFF, any.
const ClickKernels& click_kernels();

}  // namespace rigsound::analysis
