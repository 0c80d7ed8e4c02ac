// From how many excerpts were told right to where three quarters are.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/analysis/contrast.hpp"

namespace rigsound::analysis {

/// What was judged of sounds `away_bar` (> 0) from the one they are compared with.
struct Trial {
  double away_bar = 0;
  int right = 0, of = 0;
};

/// Share told right: 1/2 at no distance, a Weibull function from there up to all but kLapses.
struct Psychometric {
  static constexpr double kLapses = 0.01;

  double scale_bar = 1;  ///< where it has risen by 1 - 1/e
  double slope = 2;

  double right(double away_bar) const;
  double away_bar(double right) const;  ///< the inverse, 0.5 < right < 1 - kLapses
};

/// Maximum likelihood; at least one trial. Thread: OFF.
Psychometric fit_psychometric(const std::vector<Trial>& trials);

/// Distance at which kToldRight are told right, with the interval that holds 95 % of the fits to trials drawn
/// anew from the one found (parametric bootstrap). Values beyond the farthest trial are not reached. Thread:
/// OFF.
Reach reach_of(const std::vector<Trial>& trials, std::uint64_t seed);

}  // namespace rigsound::analysis
