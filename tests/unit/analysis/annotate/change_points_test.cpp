#include "annotate/change_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace rigsound::analysis;

namespace {

/// Squared deviations and penalties of a partition, added up as the words say.
double total_of(const Eigen::ArrayXXd& x, const std::vector<long>& borders, double penalty) {
  double total = penalty * static_cast<double>(borders.size() - 2);
  for (std::size_t i = 1; i < borders.size(); ++i) {
    const Eigen::ArrayXXd part = x.middleCols(borders[i - 1], borders[i] - borders[i - 1]);
    total += (part.colwise() - part.rowwise().mean()).square().sum();
  }
  return total;
}

/// The least total over all partitions, tried one by one.
double least_total(const Eigen::ArrayXXd& x, double penalty, long shortest, std::vector<long> borders = {0}) {
  const long n = x.cols(), from = borders.back();
  double least = 1e300;
  for (long to = from + shortest; to <= n; ++to) {
    std::vector<long> more = borders;
    more.push_back(to);
    least = std::min(least, to == n ? total_of(x, more, penalty) : least_total(x, penalty, shortest, more));
  }
  return least;
}

Eigen::ArrayXXd noise(long rows, long columns, unsigned seed) {
  std::mt19937 chance(seed);
  std::normal_distribution<double> normal;
  return Eigen::ArrayXXd::NullaryExpr(rows, columns, [&] { return normal(chance); });
}

}  // namespace

TEST_CASE("no partition is better than the one that is found") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Eigen::ArrayXXd x = noise(2, 15, seed);
    x.middleCols(4 + seed % 3, 5) += 2.0;
    for (const double penalty : {1.0, 4.0}) {
      std::vector<long> borders = {0};
      for (const ChangePoint& change : change_points(x, penalty, 3)) borders.push_back(change.first);
      borders.push_back(15);
      CHECK(total_of(x, borders, penalty) == doctest::Approx(least_total(x, penalty, 3)));
      for (std::size_t i = 1; i < borders.size(); ++i) CHECK(borders[i] - borders[i - 1] >= 3);
    }
  }
}

TEST_CASE("what a change gains is what its segments lose by being one") {
  Eigen::ArrayXXd x = Eigen::ArrayXXd::Zero(1, 40);
  x.rightCols(20) = 3;
  const std::vector<ChangePoint> changes = change_points(x, 10, 2);
  REQUIRE(changes.size() == 1);
  CHECK(changes[0].first == 20);
  CHECK(changes[0].gain == doctest::Approx(40 * 1.5 * 1.5));
  CHECK(change_points(x, 100, 2).empty());
}

TEST_CASE("series shorter than a segment have no change") {
  CHECK(change_points(noise(3, 4, 1), 1, 6).empty());
  CHECK(change_points(noise(3, 6, 1), 1, 6).empty());
}

TEST_CASE("correlated noise becomes white, whatever changes among it") {
  Eigen::ArrayXXd x = noise(3, 6000, 3);
  x.row(1) = 0.8 * x.row(0) + 0.6 * x.row(1);
  x.row(2) *= 4;
  x.middleCols(2000, 1500) += 30.0;
  const Eigen::MatrixXd whitening = whitening_of(x, 10, Eigen::ArrayXd::Constant(3, 1e-3));
  const Eigen::MatrixXd white = whitening * x.leftCols(2000).matrix(),
                        centred = white.colwise() - white.rowwise().mean();
  const Eigen::MatrixXd covariance = centred * centred.transpose() / 2000;
  CHECK((covariance - Eigen::MatrixXd::Identity(3, 3)).cwiseAbs().maxCoeff() < 0.2);
}

TEST_CASE("noise that drifts counts as much as its block means say") {
  Eigen::ArrayXXd x = noise(1, 20000, 5);
  for (long t = 1; t < x.cols(); ++t)
    x(0, t) = 0.8 * x(0, t - 1) + 0.6 * x(0, t);  // AR(1): long-run variance 9
  const Eigen::MatrixXd whitening = whitening_of(x, 100, Eigen::ArrayXd::Constant(1, 1e-3));
  CHECK(1 / whitening(0, 0) == doctest::Approx(3).epsilon(0.15));
}
