#include "clicks/selection.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace {

/// Total of one subset of the candidates by the definition of the costs; -infinity when a gap is not allowed.
double total_of(const std::vector<int>& time, const std::vector<double>& score, double T_0, long length,
                unsigned subset) {
  double total = 0;
  int last = -1;
  for (size_t i = 0; i < time.size(); ++i) {
    if (!(subset >> i & 1)) continue;
    total += score[i];
    if (last < 0)
      total -= 2 * std::min(3.0, time[i] / T_0);
    else {
      const double g = (time[i] - time[last]) / T_0;
      total -= g > 4.5 ? std::min(12.0, gap_cost(g)) : gap_cost(g);
    }
    last = int(i);
  }
  return total - 2 * std::min(3.0, double(length - time[last]) / T_0);
}

constexpr int kStrikes = 200;  // blocks apart, 15 a second

/// Two seconds of strikes among denser clutter.
Candidates strikes_in_clutter(unsigned seed) {
  TestNoise noise(seed);
  Candidates candidates;
  candidates.z = Eigen::ArrayXd::Zero(6000);
  for (int t = 20; t < 6000; t += 15 + int(50 * noise.uniform())) candidates.z(t) = 5 + 2 * noise.uniform();
  for (int t = 100; t < 6000; t += kStrikes) candidates.z(t) = 11 + 3 * noise.uniform();
  for (int t = 0; t < 6000; ++t)
    if (candidates.z(t) > 0) candidates.block.push_back(t);
  return candidates;
}

double chance_of(const Selection& selection) { return selection.total - selection.surplus; }

}  // namespace

TEST_CASE("a gap costs nothing at one period, little at a miss or a double, and too much elsewhere") {
  CHECK(gap_cost(1) == 0);
  CHECK(gap_cost(2) == doctest::Approx(2));
  CHECK(gap_cost(3) == doctest::Approx(4));
  CHECK(gap_cost(0.4) == doctest::Approx(4));
  CHECK(std::isinf(gap_cost(0.27)));
  CHECK(std::isinf(gap_cost(4.6)));
  CHECK(gap_cost(1.1) == doctest::Approx(gap_cost(1 / 1.1)));
}

TEST_CASE("the best chain is the best of all subsets") {
  TestNoise noise(51);
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<int> time;
    std::vector<double> score;
    int t = 0;
    for (int i = 0; i < 11; ++i) {
      t += 3 + int(noise.uniform() * (i == 5 ? 300 : 40));
      time.push_back(t);
      score.push_back(6 * noise.uniform() - 2);
    }
    const long length = t + 20;
    const Chain chain = best_chain(time, score, GapCosts(30), length);
    double best = -1e9;
    for (unsigned subset = 1; subset < 1u << 11; ++subset)
      best = std::max(best, total_of(time, score, 30, length, subset));
    unsigned chosen = 0;
    for (const int i : chain.chosen) chosen |= 1u << i;
    CHECK(chain.total == doctest::Approx(best));
    CHECK(total_of(time, score, 30, length, chosen) == doctest::Approx(best));
  }
}

TEST_CASE("the autocorrelation's peaks become period hypotheses") {
  TestNoise noise(52);
  Eigen::ArrayXd activity = noise.normals(6000).abs() * 0.3;
  for (int t = 50; t < 6000; t += 97) activity(t) += 8;
  const std::vector<int> periods = period_hypotheses(activity, 3000, kDrillingRates);
  CHECK(std::any_of(periods.begin(), periods.end(), [](int T) { return std::abs(T - 97) <= 3; }));
  for (const int T : periods)
    CHECK((3000.0 / T >= kDrillingRates.slowest_hz && 3000.0 / T <= kDrillingRates.fastest_hz));
}

TEST_CASE("strikes are mostly told from denser clutter, which any short period would find") {
  int found = 0;
  for (unsigned seed = 60; seed < 80; ++seed)
    if (std::abs(select_clicks(strikes_in_clutter(seed), kDrillingRates).mean_gap_blocks - kStrikes) < 10)
      ++found;
  CHECK(found >= 12);  // of 20
}

TEST_CASE("the surplus of what is selected is over all that chance gives at one of the periods") {
  for (unsigned seed = 60; seed < 64; ++seed) {
    const Candidates candidates = strikes_in_clutter(seed);
    const double chance = chance_of(select_clicks(candidates, kDrillingRates));
    double nearest = 1e9;
    for (int T = 25; T < 450; ++T)
      nearest = std::min(nearest, std::fabs(chance_of(select_at_period(candidates, T)) - chance));
    CHECK(nearest < 1e-9);
  }
}
