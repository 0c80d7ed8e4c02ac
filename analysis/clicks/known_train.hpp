// A click train heard through another whitening than the one it was found through.
#pragma once

#include <Eigen/Core>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

struct HeardTrain {
  Eigen::ArrayXd variance;  ///< sum_i beta_i^2 a^2(n - P_i), a sample
  double floor = 0;         ///< variance of all that it and the others leave
};

/// Onsets and envelope of `train` stay, its powers and the floor are those of largest likelihood in y.
/// `others`: variance of what else is known to strike, a sample; empty: nothing. Thread: OFF.
HeardTrain hear_train(const Eigen::ArrayXd& y, const ClickTrain& train, const Eigen::ArrayXd& others = {});

}  // namespace rigsound::analysis
