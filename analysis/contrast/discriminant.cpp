#include "contrast/discriminant.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace rigsound::analysis {
namespace {

constexpr double kLeastSpread = 1e-6;  // of a feature that never changes

/// Covariance of the centred examples (columns), shrunk towards as much in every direction.
Eigen::MatrixXd shrunk_covariance(const Eigen::MatrixXd& x) {
  const auto p = static_cast<double>(x.rows()), n = static_cast<double>(x.cols());
  const Eigen::MatrixXd S = x * x.transpose() / n;
  const double mean = S.trace() / p;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(x.rows(), x.rows());
  const double spread = (S - mean * identity).squaredNorm() / p;
  double error = 0;
  for (long i = 0; i < x.cols(); ++i)
    error += (x.col(i) * x.col(i).transpose() - S).squaredNorm() / (n * n * p);
  const double shrinkage = spread > 0 ? std::min(1.0, error / spread) : 1;
  return shrinkage * mean * identity + (1 - shrinkage) * S;
}

/// The parts but one, side by side.
Eigen::MatrixXd all_but(const std::vector<Eigen::MatrixXd>& parts, std::size_t left_out) {
  long columns = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) columns += i == left_out ? 0 : parts[i].cols();
  Eigen::MatrixXd together(parts.front().rows(), columns);
  long at = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == left_out) continue;
    together.middleCols(at, parts[i].cols()) = parts[i];
    at += parts[i].cols();
  }
  return together;
}

}  // namespace

Discriminant::Discriminant(const Eigen::MatrixXd& first, const Eigen::MatrixXd& second) {
  const Eigen::VectorXd mean_first = first.rowwise().mean(), mean_second = second.rowwise().mean();
  Eigen::MatrixXd within(first.rows(), first.cols() + second.cols());
  within << first.colwise() - mean_first, second.colwise() - mean_second;
  const Eigen::ArrayXd scale = (within.array().square().rowwise().mean()).sqrt().max(kLeastSpread).inverse();
  within.array().colwise() *= scale;
  const Eigen::VectorXd apart = (mean_second - mean_first).array() * scale;
  const Eigen::VectorXd weights = shrunk_covariance(within).ldlt().solve(apart);
  direction_ = weights.array() * scale;
  middle_ = direction_.dot(mean_first + mean_second) / 2;
}

Judged cross_validated(const std::vector<Eigen::MatrixXd>& first,
                       const std::vector<Eigen::MatrixXd>& second) {
  Judged judged;
  for (std::size_t part = 0; part < first.size(); ++part) {
    const Discriminant discriminant(all_but(first, part), all_but(second, part));
    for (const auto& x : first[part].colwise()) judged.right += discriminant.is_second(x) ? 0 : 1;
    for (const auto& x : second[part].colwise()) judged.right += discriminant.is_second(x) ? 1 : 0;
    judged.of += static_cast<int>(first[part].cols() + second[part].cols());
  }
  return judged;
}

}  // namespace rigsound::analysis
