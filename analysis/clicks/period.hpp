// Period hypotheses for the selection of clicks.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

struct RateRange {
  double slowest_hz = 0, fastest_hz = 0;
};

constexpr RateRange kDrillingRates{3, 120};

/// Periods (in blocks of `block_rate` Hz) worth trying: the four highest peaks of the unbiased
/// autocorrelation of `activity`, averaged over +-6 % of the lag so that jittered gaps merge, each also
/// halved and doubled, within `range`. Ascending. Thread: OFF.
std::vector<int> period_hypotheses(const Eigen::ArrayXd& activity, double block_rate, const RateRange& range);

}  // namespace rigsound::analysis
