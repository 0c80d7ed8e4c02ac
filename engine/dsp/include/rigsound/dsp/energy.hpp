// The energy of samples.
#pragma once

#include <vector>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

/// Sum of squares; its root is the L2 norm. Four accumulators of two lanes take eight samples in turn and are
/// added as dot() adds its own; what is left over comes last. Thread: any.
inline double energy(const std::vector<float>& samples) noexcept {
  const float *x = samples.data(), *const end = x + samples.size();
  Lanes s0{}, s1{}, s2{}, s3{};
  for (; end - x >= 8; x += 8) {
    const Lanes a = load(x), b = load(x + 2), c = load(x + 4), d = load(x + 6);
    s0 += a * a, s1 += b * b, s2 += c * c, s3 += d * d;
  }
  double sum = total((s0 + s1) + (s2 + s3));
  for (; x < end; ++x) sum += static_cast<double>(*x) * *x;
  return sum;
}

}  // namespace rigsound::dsp
