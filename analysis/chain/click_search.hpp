// Steps 2 to 4: the whitener that modelled powers suggest, and the chain found through it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "clicks/candidates.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/selection.hpp"
#include "denoise/factors.hpp"

namespace rigsound::analysis {

struct ClickSearch {
  Eigen::ArrayXd y;  ///< whitened, RMS 1
  Candidates candidates;
  Selection selection;

  /// What the chain has over chance, a click.
  double clearness() const;
};

/// Thread: OFF.
ClickSearch search_clicks(const std::vector<float>& x, const MeanPsd& psd);

/// Step 5; fewer than kFewestFitted clicks: there is nothing to fit. `others`: see fit_clicks(). Thread: OFF.
ClickTrain fit_found(const ClickSearch& found, FitEffort effort, const Eigen::ArrayXd& others = {});

}  // namespace rigsound::analysis
