#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/noise.hpp"
#include "clicks/envelope.hpp"
#include "clicks/integrated_energy.hpp"
#include "clicks/paper_second_stage.hpp"

using namespace rigsound::analysis;

namespace {

constexpr long kPeriod = 1800, kTrainLength = 48000;
const ClickEnvelope kShape{60, 0, 0.0016};

std::vector<long> onsets() {
  std::vector<long> P;
  for (long n = 700; n + kPeriod < kTrainLength; n += kPeriod) P.push_back(n);
  return P;
}

/// White noise under the clicks' envelopes, RMS 1.
Eigen::ArrayXd white_clicks(unsigned seed) {
  TestNoise noise(seed);
  Eigen::ArrayXd y = 1e-3 * noise.normals(kTrainLength);
  for (const long P : onsets())
    for (long n = 0; P + n < kTrainLength; ++n) y(P + n) += envelope(kShape, double(n)) * noise.normal();
  return y / std::sqrt(y.square().mean());
}

}  // namespace

TEST_CASE("the integrated energy is eq. 4") {
  TestNoise noise(71);
  const Eigen::ArrayXd y = noise.normals(300), w2 = squared_hann(31);
  CHECK(w2(15) == doctest::Approx(1));
  CHECK(w2(0) == doctest::Approx(std::pow(std::sin(kPi / 32), 4)).scale(0));
  const Eigen::ArrayXd e = integrated_energy(y, w2, 15, 10);
  REQUIRE(e.size() == 30);
  for (const long i : {0L, 7L, 29L}) {
    double expected = 0;
    for (long j = -15; j <= 15; ++j)
      if (10 * i + j >= 0 && 10 * i + j < 300) expected += y(10 * i + j) * y(10 * i + j) * w2(j + 15);
    CHECK(e(i) == doctest::Approx(expected));
  }
}

TEST_CASE("the bend of the attack follows from its middle without a search") {
  // nu rises as eq. 5 over 400 samples from each minimum to each peak: the closed form must give the bend
  // back.
  const double x = 2.0, r = 1 / (1 + std::exp(-x / 2));
  CHECK(2 * std::log(r / (1 - r)) == doctest::Approx(x));
  CHECK(envelope({400, x / 400, 1}, 200) == doctest::Approx(r));
}

TEST_CASE("every click has its peak in the first stage") {
  const FirstStage first = paper_first_stage(white_clicks(72));
  for (const long P : onsets()) {
    long nearest = kTrainLength;
    for (const EnergyPeak& peak : first.peaks) nearest = std::min(nearest, std::labs(peak.P_p - P));
    CHECK(nearest < 500);
  }
  for (const EnergyPeak& peak : first.peaks) CHECK((peak.P_l <= peak.P_p && peak.P_p <= peak.P_r));
}

TEST_CASE("flatness is least near the envelope that made the clicks") {
  const Eigen::ArrayXd y = white_clicks(73);
  PaperClicks clicks;
  clicks.P = onsets();
  clicks.beta.assign(clicks.P.size(), 1);
  const double here = flatness(y, clicks, kShape);
  CHECK(here < flatness(y, clicks, {60, 0, 0.0008}));
  CHECK(here < flatness(y, clicks, {60, 0, 0.0032}));
  PaperClicks louder = clicks;
  for (double& beta : louder.beta) beta *= 10;
  CHECK(flatness(y, louder, kShape) == doctest::Approx(here));
}

TEST_CASE("the paper's chain finds every click, all early by about the same few milliseconds") {
  const ClickTrain train = paper_clicks(white_clicks(74));
  CHECK(train.mean_gap_samples == doctest::Approx(kPeriod).epsilon(0.03));
  std::vector<long> early;
  for (const long P : onsets())
    for (const int candidate : train.P)
      if (std::labs(P - candidate) < kPeriod / 2) early.push_back(P - candidate);
  REQUIRE(early.size() >= onsets().size() - 2);
  std::sort(early.begin(), early.end());
  const long median = early[early.size() / 2];
  CHECK(median > -50);
  CHECK(median < 600);
  CHECK(early[early.size() * 9 / 10] - early[early.size() / 10] < 200);
  for (size_t i = 1; i < train.P.size(); ++i) CHECK(train.P[i] - train.P[i - 1] >= kPeriod * 0.4);
}
