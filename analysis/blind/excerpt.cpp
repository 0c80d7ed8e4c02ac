#include <algorithm>
#include <cmath>

#include "rigsound/analysis/blind_sounds.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {

std::vector<float> excerpt(const std::vector<float>& x, std::size_t from, std::size_t length) {
  constexpr std::size_t kFade = static_cast<std::size_t>(0.005 * kAnalysisRate);
  std::vector<float> y(length);
  if (from < x.size())
    std::copy_n(x.begin() + static_cast<long>(from), std::min(length, x.size() - from), y.begin());
  for (std::size_t n = 0; n < std::min(kFade, length / 2); ++n) {
    const auto gain = static_cast<float>(n) / kFade;
    y[n] *= gain;
    y[length - 1 - n] *= gain;
  }
  return y;
}

}  // namespace rigsound::analysis
