// The second strikes of a machine that strikes twice in every period.
#pragma once

#include <Eigen/Core>

#include "clicks/candidates.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// `train`, fitted to y, with a second strike after each click that has one. They are a machine's own where
/// they stand out as the clicks themselves do, come a constant time later, more than 8 ms and a tenth of the
/// period, and hold a quarter of the clicks' power: echoes are weaker, a tool bounces unevenly, and another
/// machine keeps no phase. The envelope is fitted anew: without them it falls as slowly as both together. The
/// period stays that of the first strikes. Thread: OFF.
ClickTrain with_second_strikes(const Eigen::ArrayXd& y, const Candidates& candidates, ClickTrain train);

}  // namespace rigsound::analysis
