#include "clicks/candidates.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "analysis/noise.hpp"
#include "clicks/independent_share.hpp"

using namespace rigsound::analysis;

TEST_CASE("the statistic is the likelihood ratio of two variances against one") {
  TestNoise noise(40);
  Eigen::ArrayXd before = noise.normals(5).square(), after = 4 * noise.normals(5).square() + 1, q(10);
  q << before, after;
  Eigen::ArrayXd cumulative = Eigen::ArrayXd::Zero(11);
  std::partial_sum(q.begin(), q.end(), cumulative.begin() + 1);
  const auto log_likelihood = [](const Eigen::ArrayXd& blocks, int samples) {
    return -0.5 * samples * double(blocks.size()) * (std::log(blocks.mean()) + 1);
  };
  const double gain = log_likelihood(before, 16) + log_likelihood(after, 16) - log_likelihood(q, 16);
  CHECK(step_statistic(cumulative, 5, 5, 5, 16) == doctest::Approx(std::sqrt(2 * gain)));
  CHECK(step_statistic(cumulative, 5, 5, 5, 32) == doctest::Approx(std::sqrt(4 * gain)));
}

TEST_CASE("a downward step is no candidate") {
  Eigen::ArrayXd cumulative(5);
  cumulative << 0, 4, 8, 9, 10;
  CHECK(step_statistic(cumulative, 2, 2, 2, 16) == 0);
}

TEST_CASE("of two close peaks the lower goes") {
  Eigen::ArrayXd z(12);
  z << 0, 3, 0, 5, 0, 0, 0, 4, 0, 1, 0, 9;
  CHECK(peaks(z, 2, 1) == std::vector<int>{1, 3, 7});
  CHECK(peaks(z, 2, 3) == std::vector<int>{3, 7});
}

TEST_CASE("bursts in noise are candidates at their rise") {
  TestNoise noise(41);
  Eigen::ArrayXd y = noise.normals(48000);
  for (long P = 4000; P < 48000; P += 8000)
    for (long n = 0; n < 1500 && P + n < 48000; ++n) y(P + n) *= 1 + 5 * std::exp(-double(n) / 400);
  const Candidates candidates = find_candidates(y);
  for (int P = 4000; P < 48000; P += 8000) {
    int nearest = 1 << 20;
    double z = 0;
    for (const int block : candidates.block)
      if (std::abs(block * kCandidateBlock - P) < std::abs(nearest - P))
        nearest = block * kCandidateBlock, z = candidates.z(block);
    CHECK(std::abs(nearest - P) <= 32);
    CHECK(z > 8);
  }
}

TEST_CASE("of a sliding mean of noise as many samples are independent as its correlation leaves") {
  TestNoise noise(42);
  const Eigen::ArrayXd white = noise.normals(96000);
  CHECK(independent_share(white) == doctest::Approx(1).epsilon(0.05));
  for (const long L : {4L, 8L, 12L, 40L}) {
    Eigen::ArrayXd y = Eigen::ArrayXd::Zero(white.size() - L);
    for (long k = 0; k < L; ++k) y += white.segment(k, y.size());
    const double correlations = double(2 * L * L + 1) / double(3 * L);  // sum of (1 - |k| / L)^2
    CHECK(independent_share(y) == doctest::Approx(1 / correlations).epsilon(0.1));
    CHECK(find_candidates(y).narrow == (L >= 12));
  }
}
