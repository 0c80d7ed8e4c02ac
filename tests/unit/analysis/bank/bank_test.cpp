// Steps 7 and 8 against formulas and processes whose parameters are known.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "bank/click_masks.hpp"
#include "bank/equaliser.hpp"
#include "bank/statistics.hpp"
#include "bank/third_octave.hpp"
#include "chain/segments.hpp"
#include "rigsound/analysis/bank_builder.hpp"
#include "rigsound/analysis/resynth.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "simulate/drillbench_clip.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

ClickTrain train(std::vector<int> P, std::vector<double> beta) {
  ClickTrain t;
  t.P = std::move(P);
  t.beta = std::move(beta);
  t.envelope = {40, 0.02, 0.002};
  return t;
}

/// Lognormal AR(1) series of mean 1.
std::vector<double> lognormal_series(std::size_t count, double cv, double r, SplitMix& stream) {
  const double s = std::sqrt(std::log1p(cv * cv));
  std::vector<double> series;
  double z = stream.normal();
  for (std::size_t i = 0; i < count; ++i) {
    series.push_back(std::exp(s * z - 0.5 * s * s));
    z = r * z + std::sqrt(1 - r * r) * stream.normal();
  }
  return series;
}

std::complex<double> response(const Eigen::ArrayXd& h, double f) {
  std::complex<double> sum = 0;
  for (long n = 0; n < h.size(); ++n)
    sum += h(n) * std::polar(1.0, -dsp::kTwoPi * f / 48000 * static_cast<double>(n));
  return sum;
}

/// What the chain would find in a DrillBench clip, without its errors.
ChainResult perfect_result(int id, double seconds) {
  const DrillBenchClip clip = drillbench_clip(id, seconds);
  ChainResult result;
  result.drilling_found = true;
  result.drilling = std::vector<float>(clip.clean.begin(), clip.clean.end());
  for (const SimulatedClick& c : clip.clicks) {
    result.clicks.P.push_back(c.P);
    result.clicks.beta.push_back(c.beta);
  }
  result.clicks.envelope = clip.envelope;
  result.clicks.mean_gap_samples = clip.T0;
  return result;
}

/// A recording of one segment.
SegmentedResult alone(const ChainResult& result) {
  return join_segments({{0, static_cast<long>(result.drilling.size())}}, {result});
}

double mean_square(const std::vector<float>& x) {
  double sum = 0;
  for (const float v : x) sum += static_cast<double>(v) * v;
  return sum / static_cast<double>(x.size());
}

}  // namespace

TEST_CASE("squared masks of all clicks sum to one wherever a click sounds") {
  const ClickTrain clicks = train({100, 1100, 1900, 3000, 4100}, {1, 0.5, 2, 1, 0.7});
  const ClickMasks masks(clicks, 6000);
  std::vector<double> sum(6000, 0.0);
  for (std::size_t i = 0; i < clicks.P.size(); ++i) {
    const std::vector<double> m = masks.mask(i);
    for (std::size_t n = 0; n < m.size(); ++n) {
      CHECK(m[n] >= 0);
      CHECK(m[n] <= 1);
      sum[clicks.P[i] + n] += m[n] * m[n];
    }
  }
  for (int n = 102; n < 4100 + masks.click_length() - 1 && n < 6000; ++n)
    CHECK(sum[n] == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("a click alone comes out whole") {
  const ClickTrain clicks = train({10, 20000, 40000}, {1, 1, 1});
  std::vector<float> x(60000, 0.0f);
  for (int n = 1; n < 3000; ++n) x[20000 + n] = static_cast<float>(std::sin(0.3 * n) * std::exp(-0.002 * n));
  const std::vector<float> click = ClickMasks(clicks, 60000).extract(x, 1);
  for (std::size_t n = 1; n < 3000; ++n) CHECK(click[n] == doctest::Approx(x[20000 + n]).epsilon(1e-6));
}

TEST_CASE("gap statistics give back the process they were drawn from") {
  SplitMix stream(3);
  const double T_0 = 1200, cv = 0.06, r = -0.4, miss = 0.05, twice = 0.04;
  const std::vector<double> plain = lognormal_series(40000, cv, r, stream);
  std::vector<int> P{0};
  double t = 0;
  for (const double g : plain) {
    const double u = stream.uniform();
    if (u >= miss && u < miss + twice) P.push_back(static_cast<int>(std::lround(t + 0.45 * T_0 * g)));
    t += T_0 * g * (u < miss ? 2 : 1);
    P.push_back(static_cast<int>(std::lround(t)));
  }
  ClickBank bank;
  set_gap_statistics({P}, bank);
  CHECK(bank.mean_gap_samples == doctest::Approx(T_0).epsilon(0.002));
  CHECK(bank.gap_deviation_samples == doctest::Approx(cv * T_0).epsilon(0.03));
  CHECK(bank.gap_correlation == doctest::Approx(r).epsilon(0.05));
  CHECK(bank.miss_share == doctest::Approx(miss).epsilon(0.1));
  CHECK(bank.double_share == doctest::Approx(twice).epsilon(0.15));

  ClickBank paper;
  set_plain_gap_statistics({P}, paper);
  CHECK(paper.gap_deviation_samples >
        2 * bank.gap_deviation_samples);  // what one missed strike does to a plain standard deviation
}

TEST_CASE("a double strike leaves the spread of the plain gaps alone and the mean rate right") {
  SplitMix stream(6);
  std::vector<int> P{0};
  int t = 0;
  for (int k = 1; k <= 5000; ++k) {
    if (stream.uniform() < 0.1) P.push_back(t + static_cast<int>(1500 * (0.35 + 0.15 * stream.uniform())));
    P.push_back(t += 1500);
  }
  ClickBank bank;
  set_gap_statistics({P}, bank);
  CHECK(bank.mean_gap_samples == doctest::Approx(1500));
  CHECK(bank.gap_deviation_samples < 1);
  CHECK(bank.double_share == doctest::Approx(static_cast<double>(P.size() - 1) / 5000 - 1).epsilon(0.001));
  const double recorded_gap = static_cast<double>(t) / static_cast<double>(P.size() - 1);
  CHECK(bank.mean_gap_samples * (1 + bank.miss_share) / (1 + bank.double_share) ==
        doctest::Approx(recorded_gap).epsilon(0.002));
  bank.mean_amplitude = 1;
  bank.clicks = {{1.0F}, {1.0F}};
  constexpr std::size_t kPlayed = 20000;
  const std::vector<PlayedClick> played = played_clicks(bank, kPlayed, 1);
  const double played_gap = (played.back().time - played.front().time) / (kPlayed - 1);
  CHECK(played_gap == doctest::Approx(recorded_gap).epsilon(0.01));
}

TEST_CASE("where every strike is double, the schedule is that of the pairs") {
  SplitMix stream(8);
  std::vector<int> P;
  double t = 0;
  for (const double g : lognormal_series(5000, 0.04, 0, stream)) {
    P.push_back(static_cast<int>(t)), P.push_back(static_cast<int>(t) + 1248);
    t += 5854 * g;
  }
  ClickBank bank;
  set_gap_statistics({P}, bank);
  CHECK(bank.mean_gap_samples == doctest::Approx(5854).epsilon(0.002));
  CHECK(bank.gap_deviation_samples == doctest::Approx(0.04 * 5854).epsilon(0.05));
  CHECK(bank.miss_share < 0.001);
  CHECK(bank.double_share == doctest::Approx(1).epsilon(0.002));
}

TEST_CASE("amplitude statistics give back the process, and segments do not correlate across their seam") {
  SplitMix stream(4);
  const std::vector<double> series = lognormal_series(40000, 0.3, 0.5, stream);
  ClickBank bank;
  set_amplitude_statistics({series}, bank);
  CHECK(bank.mean_amplitude == doctest::Approx(1).epsilon(0.01));
  CHECK(bank.amplitude_deviation == doctest::Approx(0.3).epsilon(0.03));
  CHECK(bank.amplitude_correlation == doctest::Approx(0.5).epsilon(0.05));
  ClickBank pieces;
  Series<double> pairs;
  for (std::size_t i = 0; i + 1 < series.size(); i += 2) pairs.push_back({series[i + 1], series[i]});
  set_amplitude_statistics(pairs, pieces);
  CHECK(pieces.amplitude_correlation == doctest::Approx(0.5).epsilon(0.06));
}

TEST_CASE("the equaliser's filter has the gain asked for and is minimum phase") {
  const auto gain_db = [](double f) { return 6 * std::sin(std::log(std::max(f, 1.0))); };
  const Eigen::ArrayXd h = minimum_phase_fir(gain_db, 1023);
  for (const double f : {200.0, 500.0, 1000.0, 3000.0, 9000.0, 20000.0})
    CHECK(20 * std::log10(std::abs(response(h, f))) == doctest::Approx(gain_db(f)).epsilon(0.05));
  // No zero outside the unit circle: the phase, followed around half the circle, comes back to where it
  // began.
  double turned = 0, before = std::arg(response(h, 0));
  for (double f = 10; f <= 24000; f += 10) {
    const double now = std::arg(response(h, f));
    turned += std::remainder(now - before, dsp::kTwoPi);
    before = now;
  }
  CHECK(std::fabs(turned) < 0.5);
  // Among filters of that gain its energy comes first.
  CHECK(h.head(64).square().sum() > 0.9 * h.square().sum());
}

TEST_CASE("third-octave levels put a tone into its band at its power") {
  std::vector<float> x(48000);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = static_cast<float>(0.5 * std::sin(dsp::kTwoPi * 1000 / 48000 * static_cast<double>(n)));
  const BandLevels levels = third_octave_levels(x);
  REQUIRE(levels.centre_hz.size() == 25);
  CHECK(levels.centre_hz[12] == doctest::Approx(1000));
  CHECK(levels.level_db[12] == doctest::Approx(10 * std::log10(0.125)).epsilon(0.002));
  CHECK(levels.level_db[20] < levels.level_db[12] - 60);
}

TEST_CASE("modulation levels peak at the rate of the envelope") {
  std::vector<float> x(96000);
  SplitMix stream(5);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = static_cast<float>(stream.normal() *
                              (1 + 0.8 * std::sin(dsp::kTwoPi * 32 / 48000 * static_cast<double>(n))));
  const BandLevels levels = modulation_levels(x);
  const auto loudest =
      std::max_element(levels.level_db.begin(), levels.level_db.end()) - levels.level_db.begin();
  CHECK(levels.centre_hz[loudest] == doctest::Approx(32));
}

TEST_CASE("a bank from true clicks plays with the level and spectrum of the clip") {
  for (const int id : {103, 104}) {
    const ChainResult truth = perfect_result(id, 4);
    const BuiltBank built = build_bank(alone(truth), Method::kClickNmf, 10, "clip");
    CHECK(built.bank.clicks.size() == 10);
    for (const auto& click : built.bank.clicks)
      CHECK(mean_square({click.begin(), click.end()}) * static_cast<double>(click.size()) ==
            doctest::Approx(1).epsilon(1e-4));
    const std::vector<float> sound = resynthesise(built.bank, 20, 99).sound;
    CHECK(10 * std::log10(mean_square(sound) / mean_square(truth.drilling.all())) ==
          doctest::Approx(0).epsilon(0.6));
    CHECK(std::fabs(10 * std::log10(mean_square(sound) / mean_square(truth.drilling.all()))) < 0.6);
    CHECK(mean_difference_db(third_octave_levels(truth.drilling.all()), third_octave_levels(sound), 50,
                             Difference::kCentred) < 0.6);
    CHECK(built.bank.mean_gap_samples == doctest::Approx(48000.0 / built.figures.rate_hz));
  }
}

TEST_CASE("two figures of the spectrum: against what the bank aims at, and against the denoised recording") {
  ChainResult taken = perfect_result(103, 4);  // 6 dB of the drilling above 2 kHz went with the background
  taken.output_psd.assign(257, 1e-3), taken.noise_psd.assign(257, 1e-4), taken.signal_psd = taken.output_psd;
  for (std::size_t bin = 22; bin < 257; ++bin) taken.signal_psd[bin] *= 4;
  const BankFigures figures = build_bank(alone(taken), Method::kClickNmf, 10, "clip").figures;
  CHECK(figures.ltas_error_db < 0.6);
  CHECK(figures.ltas_denoised_error_db > 2);
  CHECK(figures.ltas_denoised_error_db < 3.5);
}

TEST_CASE("level follows the statistics: missed strikes make the same clicks quieter") {
  const BuiltBank built = build_bank(alone(perfect_result(103, 4)), Method::kClickNmf, 10, "clip");
  ClickBank steady = built.bank, missing = built.bank;
  missing.miss_share = 0.3;
  set_level(steady, ImpactPairs(steady), 1e-2);
  set_level(missing, ImpactPairs(missing), 1e-2);
  CHECK(missing.mean_amplitude * missing.mean_amplitude ==
        doctest::Approx(1.3 / (1 + steady.miss_share) * steady.mean_amplitude * steady.mean_amplitude)
            .epsilon(0.02));
  CHECK(mean_square(resynthesise(missing, 60, 5).sound) == doctest::Approx(1e-2).epsilon(0.05));
}

TEST_CASE("the paper's method gives a bank too, without correlations") {
  const BuiltBank built = build_bank(alone(perfect_result(103, 2)), Method::kPaper, 10, "clip");
  CHECK(built.bank.clicks.size() == 10);
  CHECK(built.bank.gap_correlation == 0);
  CHECK(built.bank.amplitude_correlation == 0);
  CHECK(built.bank.miss_share == 0);
}

TEST_CASE("resynthesis repeats with its seed and obeys the rate") {
  const BuiltBank built = build_bank(alone(perfect_result(104, 2)), Method::kClickNmf, 10, "clip");
  const Resynthesis a = resynthesise(built.bank, 2, 7), b = resynthesise(built.bank, 2, 7),
                    c = resynthesise(built.bank, 2, 8);
  CHECK(a.sound == b.sound);
  CHECK(a.sound != c.sound);
  DrillControls controls;
  controls.mean_frequency_hz = 20;
  CHECK(static_cast<double>(resynthesise(built.bank, 20, 7, controls).impacts.size()) ==
        doctest::Approx(400).epsilon(0.02));
}
