// Slopes over the feed against laws that are known.
#include "bank/feed_laws.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "numeric/median_slope.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

FedBank bank_at(double feed_bar, double rate = 48000) {
  FedBank fed{feed_bar, {}};
  const double x = feed_bar - 90;
  fed.bank.sample_rate = rate;
  fed.bank.mean_gap_samples = rate / 40 * std::exp(0.001 * x);
  fed.bank.gap_deviation_samples = fed.bank.mean_gap_samples * (0.05 - 0.0003 * x);
  fed.bank.mean_amplitude = std::exp(0.004 * x);
  fed.bank.amplitude_deviation = fed.bank.mean_amplitude * (0.2 - 0.001 * x);
  fed.bank.decay = 100 / rate * std::exp(0.008 * x);
  fed.tilt_db_per_octave = -1 - 0.05 * x;
  return fed;
}

}  // namespace

TEST_CASE("three feeds give the laws, banks of any rate and with any trim; two do not") {
  std::vector<FedBank> series = {bank_at(150, 44100), bank_at(40), bank_at(90)};
  series[0].bank.mean_amplitude /= 2, series[0].bank.amplitude_deviation /= 2;
  series[0].bank.gain_db = 20 * std::log10(2.0);
  const auto laws = fit_feed_laws(series);
  REQUIRE(laws.has_value());
  CHECK(laws->ln_gap == doctest::Approx(0.001));
  CHECK(laws->ln_level == doctest::Approx(0.004));
  CHECK(laws->ln_decay == doctest::Approx(0.008));
  CHECK(laws->gap_variation == doctest::Approx(-0.0003));
  CHECK(laws->amplitude_variation == doctest::Approx(-0.001));
  CHECK(laws->tilt_db_per_octave == doctest::Approx(-0.05));
  CHECK_FALSE(fit_feed_laws({bank_at(40), bank_at(90)}).has_value());
  CHECK_FALSE(fit_feed_laws({bank_at(40), bank_at(90), bank_at(91), bank_at(90.5)}).has_value());
  CHECK_FALSE(fit_feed_laws({}).has_value());
}

TEST_CASE("one mislabelled or wrongly analysed bank in eight moves the laws by little") {
  std::vector<FedBank> series;
  for (double feed = 40; feed <= 110; feed += 10) series.push_back(bank_at(feed));
  for (const std::size_t i : {0, 3, 7}) {
    std::vector<FedBank> wrong = series;
    wrong[i].bank.mean_gap_samples *= 2;
    wrong[i].bank.mean_amplitude *= 5;
    wrong[i].bank.decay *= 3;
    const auto laws = fit_feed_laws(wrong);
    CHECK(laws->ln_gap == doctest::Approx(0.001).scale(0).epsilon(0.01));
    CHECK(laws->ln_level == doctest::Approx(0.004).scale(0).epsilon(0.01));
    CHECK(laws->ln_decay == doctest::Approx(0.008).scale(0).epsilon(0.01));
  }
}

TEST_CASE("noise on the points: the slope's error is near that of least squares") {
  SplitMix stream(4);
  double squares = 0;
  constexpr int kTrials = 2000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<LinePoint> points;
    for (int i = 0; i < 12; ++i) points.push_back({10.0 * i, 0.3 * i + stream.normal()});
    const double error = median_slope(points, 2) - 0.03;
    squares += error * error / kTrials;
  }
  const double least = 1 / std::sqrt(100 * (12 * 143 / 12.0));  // sigma / sqrt(sum of (x - mean)^2)
  CHECK(std::sqrt(squares) < 1.15 * least);
  CHECK(std::sqrt(squares) > 0.95 * least);
}
