#include "impact/impact_train.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace rigsound;

namespace {

struct Blow {
  double time, amplitude;
};

std::vector<Blow> blows(const impact::Statistics& s, double seconds, std::uint64_t seed = 3) {
  impact::ImpactTrain train(seed, 0);
  std::vector<Blow> list;
  for (double start = 0; start < seconds * 48000; start += kChunk) {
    train.process(s);
    for (const Impact& impact : train.impacts()) list.push_back({start + impact.onset, impact.amplitude});
  }
  return list;
}

struct Series {
  double mean = 0, sd = 0, lag1 = 0;
};

Series describe(const std::vector<double>& x) {
  Series r;
  for (const double v : x) r.mean += v / static_cast<double>(x.size());
  double lag = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    r.sd += (x[i] - r.mean) * (x[i] - r.mean);
    if (i > 0) lag += (x[i] - r.mean) * (x[i - 1] - r.mean);
  }
  r.lag1 = lag / r.sd;
  r.sd = std::sqrt(r.sd / static_cast<double>(x.size()));
  return r;
}

std::vector<double> gaps(const std::vector<Blow>& list) {
  std::vector<double> g;
  for (std::size_t i = 1; i < list.size(); ++i) g.push_back(list[i].time - list[i - 1].time);
  return g;
}

}  // namespace

TEST_CASE("gaps and amplitudes have the mean, deviation and lag-1 correlation asked for") {
  impact::Statistics s;
  s.mean_gap_samples = 1300.7, s.gap_variation = 0.08, s.gap_correlation = -0.4, s.amplitude_variation = 0.25,
  s.amplitude_correlation = 0.5;
  const std::vector<Blow> list = blows(s, 600);
  const Series gap = describe(gaps(list));
  CHECK(gap.mean == doctest::Approx(1300.7).epsilon(0.002));
  CHECK(gap.sd == doctest::Approx(0.08 * 1300.7).epsilon(0.03));
  CHECK(gap.lag1 == doctest::Approx(-0.4).epsilon(0.08));
  std::vector<double> amplitudes;
  for (const Blow& b : list) amplitudes.push_back(b.amplitude);
  const Series amplitude = describe(amplitudes);
  CHECK(amplitude.mean == doctest::Approx(1).epsilon(0.01));
  CHECK(amplitude.sd == doctest::Approx(0.25).epsilon(0.04));
  // a lognormal of an AR(1) series is correlated a little less than the series itself
  CHECK(amplitude.lag1 == doctest::Approx(0.5).epsilon(0.08));
}

TEST_CASE("a metronome keeps its period exactly, sample fractions included") {
  impact::Statistics s;
  s.mean_gap_samples = 1234.5678;
  const std::vector<Blow> list = blows(s, 20);
  CHECK(list.front().time == 0);
  for (std::size_t i = 0; i < list.size(); ++i)
    REQUIRE(list[i].time == doctest::Approx(1234.5678 * static_cast<double>(i)).epsilon(1e-9));
}

TEST_CASE("missed and doubled strikes come in their shares") {
  impact::Statistics s;
  s.mean_gap_samples = 1000, s.gap_variation = 0.02, s.miss_share = 0.12, s.double_share = 0.05;
  const std::vector<double> g = gaps(blows(s, 400));
  double missed = 0, parts = 0;
  for (const double gap : g) missed += gap > 1600, parts += gap < 700;
  const double doubled = parts / 2, places = static_cast<double>(g.size()) - doubled;  // of the schedule
  const auto off = [&](double count, double share) {  // in standard deviations of what chance brings
    return (count / places - share) / std::sqrt(share * (1 - share) / places);
  };
  CHECK(std::fabs(off(missed, s.miss_share)) < 3);
  CHECK(std::fabs(off(doubled, s.double_share)) < 3);
}

TEST_CASE("a rate change acts on the gap that is running") {
  impact::Statistics slow, fast;
  slow.mean_gap_samples = 9600, fast.mean_gap_samples = 600;
  impact::ImpactTrain train(1, 0);
  train.process(slow);
  REQUIRE(train.impacts().count == 1);
  int chunks = 0;
  do train.process(fast), ++chunks;
  while (train.impacts().count == 0 && chunks < 1000);
  CHECK(chunks * kChunk <= 600 + kChunk);
}

TEST_CASE("at rest nothing strikes, and the first blow after it comes at once") {
  impact::Statistics s;
  s.mean_gap_samples = 1000;
  impact::ImpactTrain train(1, 0);
  for (int i = 0; i < 10; ++i) train.process(s);
  train.process({});
  CHECK(train.impacts().count == 0);
  train.process(s);
  CHECK(train.impacts().count == 1);
  CHECK(train.impacts().first->onset == 0);
}

TEST_CASE("two booms, or two seeds, do not strike alike") {
  impact::Statistics s;
  s.mean_gap_samples = 1000, s.gap_variation = 0.1;
  CHECK(gaps(blows(s, 1, 3))[0] != gaps(blows(s, 1, 4))[0]);
  impact::ImpactTrain a(3, 0), b(3, 1);
  a.process(s), b.process(s);
  CHECK(a.impacts().first->amplitude ==
        b.impacts().first->amplitude);  // no scatter asked for: both are the mean
  s.amplitude_variation = 0.2;
  impact::ImpactTrain c(3, 0), d(3, 1);
  c.process(s), d.process(s);
  CHECK(c.impacts().first->amplitude != d.impacts().first->amplitude);
}

TEST_CASE("statistics go from one to the other evenly, the gap by ratios, and stay at either end") {
  const impact::Statistics a{1000, 0.02, 0.1, 0.01, 0.02, 0.2, 0.3},
      b{4000, 0.06, 0.5, 0.03, 0.08, 0.4, -0.1};
  const auto members = [](const impact::Statistics& s) {
    return std::array<double, 7>{
        std::log(s.mean_gap_samples), s.gap_variation,        s.gap_correlation, s.miss_share, s.double_share,
        s.amplitude_variation,        s.amplitude_correlation};
  };
  for (const double share : {-0.5, 0.0, 0.25, 0.5, 0.9, 1.0, 1.5}) {
    const auto of_a = members(a), of_b = members(b), blended = members(impact::blend(a, b, share));
    const double way = std::clamp(share, 0.0, 1.0);
    CAPTURE(share);
    for (std::size_t i = 0; i < blended.size(); ++i)
      CHECK(blended[i] == doctest::Approx(of_a[i] + way * (of_b[i] - of_a[i])).scale(0).epsilon(1e-9));
  }
}

TEST_CASE("a bank's statistics are shares of its means, at its own rate or at the one it is asked for") {
  ClickBank bank;
  bank.sample_rate = 44100, bank.mean_gap_samples = 2000, bank.gap_deviation_samples = 50;
  bank.mean_amplitude = 4, bank.amplitude_deviation = 0.5;
  bank.gap_correlation = 0.3, bank.amplitude_correlation = -0.2, bank.miss_share = 0.01,
  bank.double_share = 0.02;
  DrillControls controls;
  controls.deviation_time = 3, controls.deviation_amplitude = 2;
  const impact::Statistics own = impact::statistics_of(bank, 44100, 0, controls);
  CHECK(own.mean_gap_samples == 2000);
  CHECK(own.gap_variation == doctest::Approx(3 * 0.025));
  CHECK(own.amplitude_variation == doctest::Approx(2 * 0.125));
  CHECK(own.gap_correlation == 0.3);
  CHECK(own.amplitude_correlation == -0.2);
  CHECK(own.miss_share == 0.01);
  CHECK(own.double_share == 0.02);
  CHECK(impact::statistics_of(bank, 44100, 30, controls).mean_gap_samples == doctest::Approx(44100 / 30.0));
  controls.mean_frequency_hz = 60;
  CHECK(impact::statistics_of(bank, 44100, 30, controls).mean_gap_samples == doctest::Approx(44100 / 60.0));
}
