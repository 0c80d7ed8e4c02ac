#include "clicks/drilling_test.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigsound::analysis {
namespace {

constexpr size_t kFewestClicks = 6;
constexpr double kLeastMeanZ = 3.2;

}  // namespace

std::string no_drilling_reason(const Selection& selection) {
  if (selection.block.size() < kFewestClicks)
    return fmt::format("{} clicks, expected {} or more", selection.block.size(), kFewestClicks);
  if (selection.mean_z < kLeastMeanZ)
    return fmt::format("clicks stand out by z = {:.1f} on average, expected {} or more", selection.mean_z,
                       kLeastMeanZ);
  return {};
}

std::string no_drilling_reason(const Candidates& candidates, const ClickTrain& train) {
  Selection selection;
  const long blocks = candidates.z.size(), clicks = static_cast<long>(train.P.size());
  const auto middle = [&](long i) { return (train.P[i] + train.P[i + 1]) / 2 / kCandidateBlock; };
  for (long i = 0; i < clicks; ++i) {
    const long first = i > 0 ? middle(i - 1) : 0,
               last = std::min(i + 1 < clicks ? middle(i) : blocks, blocks);
    if (first >= last) continue;
    selection.block.push_back(train.P[i] / kCandidateBlock);
    selection.mean_z += candidates.z.segment(first, last - first).maxCoeff() / static_cast<double>(clicks);
  }
  return no_drilling_reason(selection);
}

}  // namespace rigsound::analysis
