#include "clicks/drilling_test.hpp"

#include <fmt/format.h>

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

}  // namespace rigsound::analysis
