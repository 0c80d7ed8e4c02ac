#include "clicks/known_train.hpp"

#include <algorithm>

#include "clicks/candidates.hpp"
#include "clicks/variance_model.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kHearingBlock = 8;  // samples
constexpr int kHearingSweeps = 24;

}  // namespace

HeardTrain hear_train(const Eigen::ArrayXd& y, const ClickTrain& train, const Eigen::ArrayXd& others) {
  const Eigen::ArrayXd q = block_power(y, kHearingBlock);
  ModelClicks clicks;
  clicks.onset = onsets_in_blocks(train.P, kHearingBlock);
  clicks.power = Eigen::ArrayXd::Constant(static_cast<long>(train.P.size()), q.mean());
  clicks.floor = q.mean();
  if (others.size() > 0) clicks.others = block_mean(others, kHearingBlock);
  update_powers(q, TrainPower(envelope_power(train.envelope, kHearingBlock), clicks.onset, q.size()),
                kHearingSweeps, kOutlierClip, clicks);
  // Where another machine strikes within milliseconds, either may take the other's energy: of one machine
  // all clicks are about as strong.
  if (!train.P.empty())
    clicks.power =
        (clicks.power * upper_median(std::vector<double>(clicks.power.begin(), clicks.power.end()))).sqrt();
  HeardTrain heard;
  heard.floor = clicks.floor;
  const std::vector<long> onset(train.P.begin(), train.P.end());
  TrainPower(envelope_power(train.envelope, 1), onset, y.size()).spread(clicks.power, 0, heard.variance);
  return heard;
}

}  // namespace rigsound::analysis
