// The body below the crossover and a little above: one response that explains every speed (A9).
#pragma once

#include <vector>

#include "rigsound/diesel_model.hpp"

namespace rigsound::analysis {

/// Level of the orders at one moment: 20 log10 |C_k| for k = 1, 2, ...; NaN where chance hides them.
struct OrderLevels {
  double f0 = 0;  ///< cycles a second
  int group = 0;  ///< moments of one load share their source S
  std::vector<double> db;
};

/// Least squares of 20 log |C_k| = S_k + E(k f0) + g over all moments: E on a grid of 1/18 octave, smooth in
/// its second differences, small. Empty with fewer than three speeds. Thread: OFF.
BodyResponse fit_body(const std::vector<OrderLevels>& moments);

}  // namespace rigsound::analysis
