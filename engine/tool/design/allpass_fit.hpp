// Least-squares fit of an allpass cascade to a wanted phase lag.
#pragma once

#include <vector>

#include "rigsound/tool_design.hpp"

namespace rigsound::tool {

/// One frequency at which the lag is wanted.
struct LagPoint {
  double omega = 0;   ///< rad/sample
  double lag = 0;     ///< rad
  double weight = 0;  ///< residual units per rad
};

/// An allpass of `order` whose sections each cover one full turn of the wanted lag. `points` rise in
/// omega. `width` scales the sections' bandwidth (1.2 fits most bars, 0.7 is the second try).
Allpass sliced_allpass(const std::vector<LagPoint>& points, int order, double width);

/// Levenberg-Marquardt on the logarithms of b, c and a (so that they stay positive); ends when every
/// residual is below `good_enough`, when nothing improves, or after `steps`. Thread: OFF, CT.
Allpass fit_lag(const Allpass& start, const std::vector<LagPoint>& points, int steps, double good_enough);

}  // namespace rigsound::tool
