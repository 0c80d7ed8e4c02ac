// The energy of samples.
#pragma once

#include <vector>

namespace rigsound::dsp {

/// Sum of squares; its root is the L2 norm. Thread: any.
inline double energy(const std::vector<float>& samples) noexcept {
  double sum = 0;
  for (const float x : samples) sum += static_cast<double>(x) * x;
  return sum;
}

}  // namespace rigsound::dsp
