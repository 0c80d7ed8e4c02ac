// Metrical test: adjusted R^2 of the clicks' level against their place in a bar.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

/// How much of the clicks' differences their place in a bar explains: adjusted R^2 of `level` (ln power,
/// bands x clicks) by the place, for bars of 3, 4, 6 and 8 steps of the period that fits `onset` (ascending)
/// best; the largest. About 0 for a drill, whose impacts differ at random; towards 1 for a drum machine. 0
/// where no bar comes round twice. Thread: OFF.
double rhythm(const Eigen::ArrayXXd& level, const std::vector<long>& onset);

}  // namespace rigsound::analysis
