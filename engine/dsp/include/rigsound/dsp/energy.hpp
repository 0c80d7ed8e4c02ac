// The energy of samples, and samples brought to another.
#pragma once

#include <cstddef>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

/// Sum of squares; its root is the L2 norm. Four accumulators of two lanes take eight samples in turn and are
/// added as dot() adds its own; what is left over comes last. Thread: any.
inline double energy(const float* x, std::size_t samples) noexcept {
  const float* const end = x + samples;
  Lanes s0{}, s1{}, s2{}, s3{};
  for (; end - x >= 8; x += 8) {
    const Lanes a = load(x), b = load(x + 2), c = load(x + 4), d = load(x + 6);
    s0 += a * a, s1 += b * b, s2 += c * c, s3 += d * d;
  }
  double sum = total((s0 + s1) + (s2 + s3));
  for (; x < end; ++x) sum += static_cast<double>(*x) * *x;
  return sum;
}

/// Each of them divided by `by` and rounded. Thread: any.
inline void divide(float* x, std::size_t samples, double by) noexcept {
  std::size_t n = 0;
  for (; n + 2 <= samples; n += 2) store(x + n, load(x + n) / by);
  for (; n < samples; ++n) x[n] = static_cast<float>(x[n] / by);
}

template <class Samples>
double energy(const Samples& samples) noexcept {
  return energy(samples.data(), samples.size());
}

}  // namespace rigsound::dsp
