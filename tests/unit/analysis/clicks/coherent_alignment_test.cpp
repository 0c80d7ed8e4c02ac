// Onsets of clicks that share a waveform, against the true ones.
#include "clicks/coherent_alignment.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/noise.hpp"
#include "clicks/click_fit.hpp"
#include "clicks/independent_share.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kAlignedClicks = 40;
constexpr double kAlignedGap = 1700;         // samples
constexpr int kScatter = 110, kTooFar = 24;  // 2.3 and 0.5 ms

/// Below about 1 kHz, of power 1.
Eigen::ArrayXd low_noise(TestNoise& draw, long length) {
  Eigen::ArrayXd x = draw.normals(length);
  for (int pass = 0; pass < 2; ++pass)
    for (long n = 1; n < length; ++n) x(n) = 0.88 * x(n - 1) + 0.12 * x(n);
  return x / std::sqrt(x.square().mean());
}

double fixed_modes(long n) {
  const double t = static_cast<double>(n);
  return std::exp(-t / 250) * (std::sin(0.041 * t) + std::sin(0.068 * t + 1) + std::sin(0.103 * t + 2));
}

/// Irregular true onsets, and the train that a fit would give for them, each click up to kScatter off.
struct ScatteredTrain {
  std::vector<int> truth;
  ClickTrain found;
};

ScatteredTrain scattered_train(TestNoise& draw, int clicks, int scatter) {
  ScatteredTrain s;
  for (int i = 0; i < clicks; ++i) {
    s.truth.push_back(static_cast<int>(kAlignedGap * (i + 1 + 0.1 * draw.uniform())));
    s.found.P.push_back(s.truth.back() + static_cast<int>(scatter * (2 * draw.uniform() - 1)));
    s.found.beta.push_back(1);
  }
  s.found.envelope = {40, 0, 1.0 / 250};
  s.found.mean_gap_samples = kAlignedGap;
  return s;
}

/// wave(n, noise) from each true onset on, in noise of `noise` times their power.
template <class Wave>
Eigen::ArrayXd struck(TestNoise& draw, const std::vector<int>& onsets, double noise, Wave wave) {
  const long length = onsets.back() + 3000;
  Eigen::ArrayXd y = Eigen::ArrayXd::Zero(length);
  const Eigen::ArrayXd carrier = low_noise(draw, length);
  for (const int P : onsets)
    for (long n = 0; n < 1500; ++n) y(P + n) += wave(n, carrier(P + n));
  y += std::sqrt(noise * y.square().mean()) * low_noise(draw, length);
  return y / std::sqrt(y.square().mean());
}

double modes_alone(long n, double) { return fixed_modes(n); }
double noise_of_one_envelope(long n, double carrier) {
  return std::exp(-static_cast<double>(n) / 250) * carrier;
}

/// Clicks further than kTooFar from their true onsets, what all have in common taken out.
int misplaced(const std::vector<int>& P, const std::vector<int>& truth) {
  std::vector<int> error(P.size());
  for (std::size_t i = 0; i < P.size(); ++i) error[i] = P[i] - truth[i];
  std::vector<int> sorted = error;
  std::nth_element(sorted.begin(), sorted.begin() + sorted.size() / 2, sorted.end());
  const int common = sorted[sorted.size() / 2];
  return static_cast<int>(
      std::count_if(error.begin(), error.end(), [&](int e) { return std::abs(e - common) > kTooFar; }));
}

}  // namespace

TEST_CASE(
    "clicks of one waveform in noise of twice their power are put where it begins, within half a "
    "millisecond") {
  TestNoise draw(5);
  const ScatteredTrain train = scattered_train(draw, kAlignedClicks, kScatter);
  const Eigen::ArrayXd y = struck(draw, train.truth, 2, modes_alone);
  REQUIRE(independent_share(y) < 0.2);
  REQUIRE(misplaced(train.found.P, train.truth) > kAlignedClicks / 2);
  const ClickTrain aligned = aligned_to_waveform(y, train.found);
  REQUIRE(aligned.P.size() == train.truth.size());
  CHECK(std::is_sorted(aligned.P.begin(), aligned.P.end()));
  CHECK(misplaced(aligned.P, train.truth) <= 2);
}

TEST_CASE("clicks lie as a whole where the variance puts the true ones, and the envelope is theirs") {
  TestNoise draw(6);
  const ScatteredTrain train = scattered_train(draw, kAlignedClicks, kScatter);
  const Eigen::ArrayXd y = struck(draw, train.truth, 0.2, modes_alone);
  ClickTrain short_lived = train.found;
  short_lived.envelope.decay = 1.0 / 120;
  ClickTrain exact = short_lived;
  exact.P = train.truth;
  const ClickTrain aligned = aligned_to_waveform(y, short_lived), right = refitted(y, exact);
  double apart = 0;
  for (std::size_t i = 0; i < aligned.P.size(); ++i) apart += aligned.P[i] - right.P[i];
  CHECK(std::fabs(apart) / kAlignedClicks < 24);
  CHECK(aligned.envelope.decay == doctest::Approx(1.0 / 250).epsilon(0.2));
  CHECK(aligned.beta.size() == aligned.P.size());
}

TEST_CASE("clicks whose noise is drawn anew stay where their variance put them") {
  TestNoise draw(7);
  const ScatteredTrain train = scattered_train(draw, kAlignedClicks, kScatter);
  const Eigen::ArrayXd y = struck(draw, train.truth, 0.2, noise_of_one_envelope);
  REQUIRE(independent_share(y) < 0.2);
  CHECK(aligned_to_waveform(y, train.found).P == train.found.P);
}

TEST_CASE("a train that needs no alignment, or is too short for one, is left as it is") {
  TestNoise draw(8);
  const ScatteredTrain exact = scattered_train(draw, kAlignedClicks, 0),
                       few = scattered_train(draw, 5, kScatter);
  CHECK(aligned_to_waveform(struck(draw, exact.truth, 0.05, modes_alone), exact.found).P == exact.found.P);
  CHECK(aligned_to_waveform(struck(draw, few.truth, 0.2, modes_alone), few.found).P == few.found.P);
}

TEST_CASE("in a wide band the variance is believed") {
  TestNoise draw(9);
  const ScatteredTrain train = scattered_train(draw, kAlignedClicks, kScatter);
  Eigen::ArrayXd y = struck(draw, train.truth, 0, modes_alone);
  y += 3 * draw.normals(y.size());
  REQUIRE(independent_share(y) > 0.4);
  CHECK(aligned_to_waveform(y, train.found).P == train.found.P);
}
