// The simplex method (Lagarias et al. 1998, the drilling paper's [19]) through NLopt.
#pragma once

#include <functional>
#include <vector>

namespace rigsound::analysis {

struct SimplexOptions {
  std::vector<double> step;       ///< of the first simplex, per parameter
  std::vector<double> tolerance;  ///< on each parameter
  std::vector<double> lower, upper;
  int evaluations = 100;
};

/// The best parameters seen within the bounds, from `start` (clamped into them). Deterministic. Thread: OFF.
std::vector<double> nelder_mead(const std::function<double(const std::vector<double>&)>& cost,
                                std::vector<double> start, const SimplexOptions& options);

}  // namespace rigsound::analysis
