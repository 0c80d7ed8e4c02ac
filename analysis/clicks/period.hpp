// Period hypotheses for the selection of clicks.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

constexpr double kMinRate_hz = 6, kMaxRate_hz = 90;

/// Periods (in blocks of `block_rate` Hz) worth trying: the four highest peaks of the unbiased
/// autocorrelation of `activity`, averaged over +-6 % of the lag so that jittered gaps merge, each also
/// halved and doubled, within kMinRate_hz … kMaxRate_hz. Ascending. Thread: OFF.
std::vector<int> period_hypotheses(const Eigen::ArrayXd& activity, double block_rate);

}  // namespace rigsound::analysis
