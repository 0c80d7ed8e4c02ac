// Metrical test: are the clicks' levels and strengths explained by their place in a bar?
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

/// How much of the clicks' differences their place in a bar explains: adjusted R^2 of `level` (ln power,
/// bands x clicks) by the place, for bars of 3 to 12 steps of the period that fits `onset` (ascending) best;
/// the largest. About 0 for a drill, whose impacts differ at random; a third for a diesel, whose cylinders
/// differ and come round every cycle; towards 1 for a drum machine. 0 where no bar comes round three times.
/// Thread: OFF.
double rhythm(const Eigen::ArrayXXd& level, const std::vector<long>& onset);

/// How surely the place in a bar explains the fitted strengths beta_i, which are far more exact than a band's
/// level: -log10 of the smallest p of F tests for bars of 3 to 12 steps, of even bars over the alternation of
/// strong and weak that double impacts have. Below 2.5 for drills, tens for an engine. 0 where no bar comes
/// round three times. Thread: OFF.
double strength_rhythm(const std::vector<double>& beta, const std::vector<long>& onset);

}  // namespace rigsound::analysis
