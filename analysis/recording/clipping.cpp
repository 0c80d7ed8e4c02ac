#include "recording/clipping.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {

double clipped_share(const std::vector<float>& x) {
  constexpr float kTop = 0.9999F;  // of the peak; a pure tone has 0.9 % of its samples there
  float peak = 0;
  for (const float v : x) peak = std::max(peak, std::fabs(v));
  const auto on_top = [&](float v) { return std::fabs(v) > kTop * peak; };
  std::size_t clipped = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const bool before = n > 0 && on_top(x[n - 1]), after = n + 1 < x.size() && on_top(x[n + 1]);
    clipped += on_top(x[n]) && (before || after);
  }
  return x.empty() || peak == 0 ? 0 : static_cast<double>(clipped) / static_cast<double>(x.size());
}

}  // namespace rigsound::analysis
