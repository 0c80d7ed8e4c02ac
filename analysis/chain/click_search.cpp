#include "chain/click_search.hpp"

#include <algorithm>

#include "clicks/whitening.hpp"

namespace rigsound::analysis {

double ClickSearch::clearness() const {
  return selection.surplus / static_cast<double>(std::max<std::size_t>(selection.block.size(), 1));
}

ClickSearch search_clicks(const std::vector<float>& x, const MeanPsd& psd) {
  ClickSearch found;
  found.y = whiten(x, noise_aware_whitener(psd.S, psd.N));
  found.candidates = find_candidates(found.y);
  found.selection = select_clicks(found.candidates, kDrillingRates);
  return found;
}

ClickTrain fit_found(const ClickSearch& found, FitEffort effort, const Eigen::ArrayXd& others) {
  if (found.selection.block.size() < kFewestFitted) return {};
  return fit_clicks(found.y, found.candidates, found.selection, effort, others);
}

}  // namespace rigsound::analysis
