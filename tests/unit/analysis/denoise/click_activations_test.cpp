#include "denoise/click_activations.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "kernels/is_kernels.hpp"

using namespace rigsound::analysis;

namespace {

ClickTrain two_clicks() {
  ClickTrain train;
  train.P = {6400, 14003};
  train.beta = {1, 0.5};
  train.envelope = {64, 0, 0};
  train.mean_gap_samples = 1600;
  return train;
}

/// The definition, sample by sample: sum_i beta_i^2 sum_t a_j^2(t - P_i) w^2(t - 128 n).
double direct(const ClickTrain& train, double decay, int frame) {
  const Eigen::ArrayXf w = hann(kChainStft.window);
  const int middle = kChainStft.window / 2;
  double sum = 0;
  for (size_t i = 0; i < train.P.size(); ++i)
    for (int k = 0; k < kChainStft.window; ++k) {
      const double t = frame * kChainStft.hop - middle + k - train.P[i], N_a = train.envelope.attack_samples;
      const double a = t < 0 ? 0 : t < N_a ? t / N_a : std::exp(-decay * (t - N_a));
      sum += train.beta[i] * train.beta[i] * a * a * double(w(k)) * double(w(k));
    }
  return sum;
}

}  // namespace

TEST_CASE("the rows follow the energy of the clicks through the window, with mean one") {
  const ClickTrain train = two_clicks();
  const int frames = 150, padded = 160;
  const Grid rows = click_activations(train, kUsualDecays, frames, padded);
  for (int j = 0; j < kDecayCount; ++j) {
    CHECK(rows.row(j).head(frames).mean() == doctest::Approx(1).epsilon(1e-4));
    CHECK(rows.row(j).tail(padded - frames).maxCoeff() == 0);
    Eigen::ArrayXd expected(frames);
    for (int n = 0; n < frames; ++n) expected(n) = direct(train, kUsualDecays[j] / train.mean_gap_samples, n);
    expected /= expected.mean();
    const double error = (rows.row(j).head(frames).transpose().cast<double>() - expected).abs().maxCoeff();
    CHECK(error < 0.03 * expected.maxCoeff());
  }
}

TEST_CASE("the decays around an envelope reach from its slow modes to the fastest, in equal ratios") {
  ClickTrain train = two_clicks();
  train.envelope.decay = 3 / train.mean_gap_samples;
  const Decays decays = decays_around(train);
  CHECK(decays.front() == doctest::Approx(1.2));
  CHECK(decays.back() == doctest::Approx(12));
  for (int j = 2; j < kDecayCount; ++j)
    CHECK(decays[j] / decays[j - 1] == doctest::Approx(decays[1] / decays[0]));
  train.envelope.decay = 0.7 / train.mean_gap_samples;
  CHECK(decays_around(train).front() == doctest::Approx(0.5));
}
