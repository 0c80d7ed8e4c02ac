#include "clicks/independent_share.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kFarthestLag = 64, kEvery = 16;  // samples

}  // namespace

double independent_share(const Eigen::ArrayXd& y) {
  Eigen::ArrayXd r = Eigen::ArrayXd::Zero(kFarthestLag);
  for (long n = 0; n + kFarthestLag <= y.size(); n += kEvery) r += y(n) * y.segment(n, kFarthestLag);
  const double at_zero = r(0) * r(0);
  return at_zero > 0 ? at_zero / (2 * r.square().sum() - at_zero) : 1;
}

}  // namespace rigsound::analysis
