#include "annotate/change_points.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

namespace rigsound::analysis {
namespace {

/// Squared deviations from the mean over columns [from, to).
class Deviations {
 public:
  explicit Deviations(const Eigen::ArrayXXd& x)
      : sums_(Eigen::ArrayXXd::Zero(x.rows(), x.cols() + 1)), squares_(Eigen::ArrayXd::Zero(x.cols() + 1)) {
    for (long t = 0; t < x.cols(); ++t) {
      sums_.col(t + 1) = sums_.col(t) + x.col(t);
      squares_[t + 1] = squares_[t] + x.col(t).square().sum();
    }
  }

  double cost(long from, long to) const {
    return squares_[to] - squares_[from] -
           (sums_.col(to) - sums_.col(from)).square().sum() / static_cast<double>(to - from);
  }

 private:
  Eigen::ArrayXXd sums_;
  Eigen::ArrayXd squares_;
};

/// The quarter of them that is smallest ends there.
double lower_quartile(std::vector<double> values) {
  const auto place = values.begin() + static_cast<long>(values.size() / 4);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

std::vector<ChangePoint> change_points(const Eigen::ArrayXXd& white, double penalty, long shortest,
                                       const std::function<void(long)>& each) {
  const long n = white.cols();
  const Deviations deviations(white);
  std::vector<double> best(static_cast<std::size_t>(n + 1), std::numeric_limits<double>::infinity());
  std::vector<long> last(static_cast<std::size_t>(n + 1), 0);
  // A start that another beats stays for as long as the other is too near to be the last change itself.
  struct Candidate {
    long start, beaten_at;
  };
  constexpr long kNever = std::numeric_limits<long>::max() / 2;
  std::vector<Candidate> candidates = {{0, kNever}};
  best[0] = -penalty;
  for (long t = shortest; t <= n; ++t) {
    double& total = best[static_cast<std::size_t>(t)];
    std::vector<double> costs;
    for (const Candidate& c : candidates) {
      costs.push_back(best[static_cast<std::size_t>(c.start)] + deviations.cost(c.start, t));
      if (costs.back() + penalty < total) {
        total = costs.back() + penalty;
        last[static_cast<std::size_t>(t)] = c.start;
      }
    }
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (costs[i] > total) candidates[i].beaten_at = std::min(candidates[i].beaten_at, t);
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return t >= c.beaten_at + shortest; }),
                     candidates.end());
    if (t + 1 - shortest >= shortest) candidates.push_back({t + 1 - shortest, kNever});
    if (each) each(t);
  }
  std::vector<long> borders = {n};
  while (borders.back() > 0) borders.push_back(last[static_cast<std::size_t>(borders.back())]);
  std::reverse(borders.begin(), borders.end());
  std::vector<ChangePoint> changes;
  for (std::size_t i = 1; i + 1 < borders.size(); ++i)
    changes.push_back({borders[i], deviations.cost(borders[i - 1], borders[i + 1]) -
                                       deviations.cost(borders[i - 1], borders[i]) -
                                       deviations.cost(borders[i], borders[i + 1])});
  return changes;
}

Eigen::MatrixXd whitening_of(const Eigen::ArrayXXd& series, long block, const Eigen::ArrayXd& floor) {
  constexpr double kBound = 2, kQuartileOfNormal = 0.3186, kBoundedVariance = 0.921;
  const long rows = series.rows(), blocks = series.cols() / block, count = std::max(0L, blocks - 1);
  Eigen::MatrixXd differences(rows, count);
  for (long b = 0; b < count; ++b)
    differences.col(b) = series.middleCols((b + 1) * block, block).rowwise().mean() -
                         series.middleCols(b * block, block).rowwise().mean();
  const double scale = static_cast<double>(block) / 2;  // variance a column, of the difference of two means
  for (long r = 0; r < rows && count > 0; ++r) {
    std::vector<double> sizes;
    for (long b = 0; b < count; ++b) sizes.push_back(std::abs(differences(r, b)));
    const double deviation = lower_quartile(sizes) / kQuartileOfNormal;
    differences.row(r) = differences.row(r).cwiseMin(kBound * deviation).cwiseMax(-kBound * deviation);
  }
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(rows, rows);
  if (count > 0)
    covariance =
        scale / (kBoundedVariance * static_cast<double>(count)) * (differences * differences.transpose());
  const double few = static_cast<double>(2 * rows) / static_cast<double>(2 * rows + count);
  Eigen::MatrixXd shrunk = (1 - few) * covariance;
  shrunk.diagonal() = covariance.diagonal() + floor.square().matrix();
  return shrunk.llt().matrixL().solve(Eigen::MatrixXd::Identity(rows, rows));
}

}  // namespace rigsound::analysis
