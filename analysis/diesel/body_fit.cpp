#include "diesel/body_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rigsound::analysis {
namespace {

constexpr double kLow_hz = 30, kHigh_hz = 2400;
constexpr double kSmooth = 0.3, kRidge = 0.02;
constexpr double kSameSpeed = 1.04;  // closer than this is one speed
constexpr int kFewestSpeeds = 3;

int distinct_speeds(const std::vector<OrderLevels>& moments) {
  std::vector<double> f;
  for (const OrderLevels& m : moments) f.push_back(m.f0);
  std::sort(f.begin(), f.end());
  int count = 0;
  double last = 0;
  for (const double x : f)
    if (x > kSameSpeed * last) ++count, last = x;
  return count;
}

}  // namespace

BodyResponse fit_body(const std::vector<OrderLevels>& moments) {
  BodyResponse E;
  if (distinct_speeds(moments) < kFewestSpeeds) return E;
  const auto grid = static_cast<Eigen::Index>(std::ceil(std::log2(kHigh_hz / kLow_hz) * E.per_octave)) + 1;
  std::map<std::pair<int, int>, Eigen::Index> source;  // (group, order) -> column
  const Eigen::Index levels = grid + static_cast<Eigen::Index>(moments.size());
  const auto column = [&](int group, int k) {
    return source.emplace(std::make_pair(group, k), levels + static_cast<Eigen::Index>(source.size()))
        .first->second;
  };
  struct Row {
    Eigen::Index e, s, g;
    double way, db;
  };
  std::vector<Row> rows;
  for (std::size_t t = 0; t < moments.size(); ++t)
    for (std::size_t k = 1; k <= moments[t].db.size(); ++k) {
      const double f = static_cast<double>(k) * moments[t].f0, db = moments[t].db[k - 1];
      if (f < kLow_hz || f > kHigh_hz || std::isnan(db)) continue;
      const double at = std::log2(f / kLow_hz) * E.per_octave;
      const auto e = std::min(static_cast<Eigen::Index>(at), grid - 2);
      rows.push_back({e, column(moments[t].group, static_cast<int>(k)), grid + static_cast<Eigen::Index>(t),
                      at - static_cast<double>(e), db});
    }
  const Eigen::Index unknowns = levels + static_cast<Eigen::Index>(source.size());
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (const Row& r : rows) {
    const std::pair<Eigen::Index, double> terms[] = {
        {r.e, 1 - r.way}, {r.e + 1, r.way}, {r.s, 1.0}, {r.g, 1.0}};
    for (const auto& [i, a] : terms) {
      right[i] += a * r.db;
      for (const auto& [j, b] : terms) normal(i, j) += a * b;
    }
  }
  constexpr double kDifference[3] = {1, -2, 1};
  for (Eigen::Index i = 0; i + 2 < grid; ++i)
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) normal(i + a, i + b) += kSmooth * kDifference[a] * kDifference[b];
  for (Eigen::Index i = 0; i < unknowns; ++i) normal(i, i) += i < levels ? kRidge : 1e-6;
  const Eigen::VectorXd solution = normal.ldlt().solve(right);
  E.f_min = kLow_hz;
  for (Eigen::Index i = 0; i < grid; ++i) E.db.push_back(static_cast<float>(solution[i]));
  return E;
}

}  // namespace rigsound::analysis
