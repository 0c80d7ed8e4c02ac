#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/noise.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/factors.hpp"
#include "denoise/initial_nmf.hpp"
#include "denoise/word_fit.hpp"
#include "kernels/is_kernels.hpp"

using namespace rigsound::analysis;

namespace rigsound::analysis {
extern const IsKernels kIsKernels_baseline;
}

namespace {

/// A spectrogram of Gaussian noise of power `L`: exponentially distributed cells, padded for the kernels.
PowerSpectrogram noisy_power(const Grid& L, unsigned seed) {
  TestNoise noise(seed);
  PowerSpectrogram power;
  power.frames = int(L.cols());
  power.P = Grid::Zero(L.rows(), (L.cols() + kLanes - 1) / kLanes * kLanes);
  for (int m = 0; m < L.rows(); ++m)
    for (int n = 0; n < L.cols(); ++n)
      power.P(m, n) = L(m, n) * float(-std::log(1 - noise.uniform())) + 1e-7f;
  return power;
}

ClickTrain regular_train() {
  ClickTrain train;
  for (int P = 900; P < 46000; P += 2000) train.P.push_back(P), train.beta.push_back(1);
  train.envelope = {40, 0, 2.5 / 2000};
  train.mean_gap_samples = 2000;
  return train;
}

double total(const Grid& cells) { return cells.cast<double>().sum(); }

}  // namespace

TEST_CASE("hat functions sum to one everywhere") {
  for (const int knots : {1, 2, 5}) {
    const Grid rows = hats(knots, 100, 112);
    for (int n = 0; n < 100; ++n) CHECK(rows.col(n).sum() == doctest::Approx(1));
    CHECK(rows.rightCols(12).abs().maxCoeff() == 0);
  }
}

TEST_CASE("the 20 % quantile finds the level of a noise under rare loud events") {
  Grid L = Grid::Constant(40, 2000, 2.0f);
  for (int n = 0; n < 2000; n += 25) L.col(n) = 200;
  const PowerSpectrogram power = noisy_power(L, 3);
  const Eigen::ArrayXf level = WordFit(power).noise(1.0f);
  CHECK(level.mean() == doctest::Approx(2.0).epsilon(0.15));
}

TEST_CASE("every instruction set gives the same bits, and those of the formula") {
  constexpr int kFrames = 150, kWords = 4, kBins = 3;
  TestNoise noise(6);
  Grid P(kFrames, kLanes), H = Grid::Zero(kWords, 160), start(kBins, kWords);
  for (float& power : P.reshaped()) power = float(-std::log(1 - noise.uniform())) + 1e-7f;
  for (float& activation : H.leftCols(kFrames).reshaped()) activation = float(noise.uniform()) + 0.1f;
  for (float& power : start.reshaped()) power = float(noise.uniform()) + 0.1f;
  const Activations activations{H.data(), kWords, 160};
  for (const float exponent : {0.7f, 1.0f, 4.0f}) {
    Grid here = start, baseline = start;
    is_kernels().fit_bins({P.data(), kFrames, here.data(), kBins}, activations, {&exponent, 1, 1}, 1e-10f);
    kIsKernels_baseline.fit_bins({P.data(), kFrames, baseline.data(), kBins}, activations, {&exponent, 1, 1},
                                 1e-10f);
    CHECK((here == baseline).all());
    const Eigen::ArrayXXd h = H.leftCols(kFrames).cast<double>(), w = start.cast<double>();
    for (int m = 0; m < kBins; ++m) {
      const Eigen::ArrayXd L = (h.matrix().transpose() * w.row(m).matrix().transpose()).array();
      for (int k = 0; k < kWords; ++k) {
        const Eigen::ArrayXd row = h.row(k).transpose(), power = P.col(m).cast<double>();
        const double ratio = (row * power / L.square()).sum() / (row / L).sum();
        const double factor =
            exponent > 1 ? std::clamp<double>(std::pow(ratio, exponent), 1 / kLargestStep, kLargestStep)
                         : std::pow(ratio, exponent);
        CHECK(here(m, k) == doctest::Approx(w(m, k) * factor).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("the activations' sums are those of the formula over the bins, with the same bits everywhere") {
  constexpr int kFrames = 32, kWords = 5, kBins = 7, kUpdated = 3;
  TestNoise noise(14);
  Grid P(kBins, kFrames), W(kBins, kWords), H(kWords, kFrames);
  for (Grid* grid : {&P, &W, &H})
    for (float& value : grid->reshaped()) value = float(noise.uniform()) + 0.1f;
  const PowerRows power{P.data(), W.data(), kBins};
  const Activations activations{H.data(), kWords, kFrames};
  Grid above(kUpdated, kFrames), below = above, same_above = above, same_below = above;
  is_kernels().sum_over_bins(power, activations, kUpdated, above.data(), below.data());
  kIsKernels_baseline.sum_over_bins(power, activations, kUpdated, same_above.data(), same_below.data());
  CHECK((above == same_above).all());
  CHECK((below == same_below).all());
  const Eigen::MatrixXd w = W.cast<double>(), L = w * H.cast<double>().matrix(),
                        R = P.cast<double>() / L.array().square(), I = L.array().inverse();
  CHECK(((w.transpose() * R).topRows(kUpdated).array() / above.cast<double>() - 1).abs().maxCoeff() < 1e-5);
  CHECK(((w.transpose() * I).topRows(kUpdated).array() / below.cast<double>() - 1).abs().maxCoeff() < 1e-5);
}

TEST_CASE("the divergence of a cell is that of the formula over 14 decades, with the same bits everywhere") {
  constexpr int kCells = 512;
  Eigen::ArrayXf P(kCells), L(kCells), here(kCells), baseline(kCells);
  TestNoise noise(15);
  for (int n = 0; n < kCells; ++n) {
    P(n) = std::pow(10.0f, 14.0f * float(n) / kCells - 10) * (1 + float(noise.uniform()));
    L(n) = 0.5f + float(noise.uniform());
  }
  is_kernels().divergence(P.data(), L.data(), kCells, here.data());
  kIsKernels_baseline.divergence(P.data(), L.data(), kCells, baseline.data());
  CHECK((here == baseline).all());
  const Eigen::ArrayXd ratio = P.cast<double>() / L.cast<double>(), formula = ratio - ratio.log() - 1;
  CHECK(((here.cast<double>() - formula).abs() / (1 + formula)).maxCoeff() < 3e-7);
}

TEST_CASE("mean powers are the means of the modelled ones") {
  const PowerSpectrogram power = noisy_power(Grid::Constant(20, 150, 2.0f), 15);
  const Factors factors = cs_nmf(WordFit(power), {{regular_train()}}, {});
  const PsdPair psd = modelled_psd(factors, power);
  const MeanPsd mean = mean_psd(factors, power);
  CHECK((psd.S.cast<double>().rowwise().mean() / mean.S - 1).abs().maxCoeff() < 1e-5);
  CHECK((psd.N.cast<double>().rowwise().mean() / mean.N - 1).abs().maxCoeff() < 1e-5);
}

TEST_CASE("three rounds of fast updates come as far as 102 plain ones, in every bin") {
  const PowerSpectrogram power = noisy_power(Grid::Constant(37, 375, 1.0f), 7);
  Factors fast;
  fast.signal_words = kDecayCount;
  fast.H = Grid(kDecayCount + 1, power.padded());
  fast.H << click_activations(regular_train(), kUsualDecays, 375, power.padded()),
      hats(1, 375, power.padded());
  fast.W = Grid::Constant(37, kDecayCount + 1, 0.3f);
  Factors plain = fast, start = fast;
  WordFit(power).update(fast_updates(3), nullptr, fast);
  WordFit(power).update(plain_updates(102), nullptr, plain);
  const Eigen::ArrayXf left = itakura_saito(power, plain).rowwise().mean(),
                       left_fast = itakura_saito(power, fast).rowwise().mean(),
                       first = itakura_saito(power, start).rowwise().mean();
  CHECK(((left_fast - left).abs() < 0.02f * (first - left)).all());
}

TEST_CASE(
    "with exponent 0.5 no iteration makes the initial factorisation worse, with 0.7 all together make it "
    "better") {
  Grid L(30, 200);
  for (int m = 0; m < 30; ++m)
    for (int n = 0; n < 200; ++n) L(m, n) = 0.3f + (n % 20 == 0 ? 5.0f : 0.0f) * float(m + 1) / 30;
  const PowerSpectrogram power = noisy_power(L, 8);
  InitialNmfOptions options;
  options.exponent = 0.5f;
  double last = 1e30;
  for (options.iterations = 0; options.iterations < 25; ++options.iterations) {
    const double divergence = total(itakura_saito(power, initial_nmf(WordFit(power), options)));
    CHECK(divergence <= last * (1 + 1e-6));
    last = divergence;
  }
  options.exponent = 0.7f;
  options.iterations = 0;
  const double start = total(itakura_saito(power, initial_nmf(WordFit(power), options)));
  options.iterations = 80;
  CHECK(total(itakura_saito(power, initial_nmf(WordFit(power), options))) < 0.8 * start);
}

TEST_CASE("a factorisation of noise by its own power leaves Euler's constant per cell") {
  const PowerSpectrogram power = noisy_power(Grid::Constant(64, 1000, 3.0f), 9);
  const Eigen::ArrayXf everywhere = Eigen::ArrayXf::Ones(1000);
  const auto by_bin = divergence_by_bin(power, itakura_saito(power, background_nmf(WordFit(power))),
                                        everywhere, power.bins());
  CHECK(by_bin.size() == 64);
  CHECK(by_bin.mean() == doctest::Approx(kNoiseDivergence).epsilon(0.01));
}

TEST_CASE("click-synchronous words find the two spectra a mixture was made of") {
  const ClickTrain train = regular_train();
  const int frames = 375;
  const PowerSpectrogram shape = noisy_power(Grid::Constant(32, frames, 1.0f), 10);
  CsNmfOptions options;
  const Factors like = cs_nmf(WordFit(shape), {{train}}, options);
  Grid S(32, frames), N(32, frames);
  for (int m = 0; m < 32; ++m) {
    S.row(m) = like.H.row(2).head(frames) * (m < 16 ? 4.0f : 0.01f);
    N.row(m).setConstant(m < 16 ? 0.02f : 1.0f);
  }
  const PowerSpectrogram power = noisy_power(S + N, 11);
  const PsdPair psd = modelled_psd(cs_nmf(WordFit(power), {{train}}, options), power);
  CHECK(psd.S.topRows(16).mean() == doctest::Approx(S.topRows(16).mean()).epsilon(0.1));
  CHECK(psd.N.bottomRows(16).mean() == doctest::Approx(1.0).epsilon(0.1));
  CHECK(psd.S.bottomRows(16).mean() < 0.15);
}

TEST_CASE("a word's cost divides its update") {
  const PowerSpectrogram power = noisy_power(Grid::Constant(1, 150, 1.0f), 5);
  Factors f;
  f.H = Grid::Constant(2, power.padded(), 1.0f);
  f.W = Grid::Constant(1, 2, 0.5f);
  const float cost[2] = {1, 1.25f};
  WordFit(power).update(plain_updates(1), cost, f);
  CHECK(f.W(0, 0) / f.W(0, 1) == doctest::Approx(1.25));
}

TEST_CASE("steady noise goes to the background where slow tails are dear, and loud slow tails stay") {
  ClickTrain train = regular_train();
  train.envelope.decay = 3.0 / 2000;  // 26 dB from click to click
  const int frames = 375;
  const Decays decays = decays_around(train);
  CsNmfOptions free, dear;
  dear.slow_cost = 0.06f;
  const PowerSpectrogram noise = noisy_power(Grid::Constant(64, frames, 1.0f), 12);
  const auto drilling = [&](const PowerSpectrogram& power, const CsNmfOptions& options) {
    return modelled_psd(cs_nmf(WordFit(power), {{train, decays}}, options), power).S.mean();
  };
  CHECK(drilling(noise, dear) < 0.7 * drilling(noise, free));
  const Grid tails = click_activations(train, decays, frames, frames).row(0).replicate(64, 1);
  const PowerSpectrogram ringing = noisy_power(tails + 0.01f, 13);
  CHECK(drilling(ringing, dear) > 0.8 * drilling(ringing, free));
}

TEST_CASE(
    "the gain is Wiener's, less where a bin hardly holds anything, for a quarter of a per cent more error") {
  const int frames = 200;
  const Spectrogram X = Spectrogram::Constant(1, frames, {1.0f, -1.0f});
  Grid S(1, frames);
  const Grid N = Grid::Constant(1, frames, 1.0f);
  for (int n = 0; n < frames; ++n) S(0, n) = 10 * std::exp(-0.08f * float(n));
  const Grid G = S / (S + N), gain = wiener(X, {S, N}).real();
  CHECK((gain + wiener(X, {S, N}).imag()).abs().maxCoeff() == doctest::Approx(0));
  CHECK(gain(0, 0) == doctest::Approx(G(0, 0)).epsilon(0.01));
  CHECK(gain(0, frames - 1) < 0.01 * G(0, frames - 1));
  const auto error = [&](const Grid& g) { return (S * (1 - g).square() + N * g.square()).mean(); };
  CHECK(error(gain) > error(G));
  CHECK(error(gain) < (1 + 0.0025) * error(G));
}
