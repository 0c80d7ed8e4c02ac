#include <doctest/doctest.h>

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/drillbench_clip.hpp"
#include "simulate/situation_recording.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

double rms(const std::vector<double>& x) {
  double energy = 0;
  for (const double v : x) energy += v * v;
  return std::sqrt(energy / static_cast<double>(x.size()));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double ab = 0;
  for (std::size_t n = 0; n < a.size(); ++n) ab += a[n] * b[n];
  return ab / static_cast<double>(a.size()) / rms(a) / rms(b);
}

/// Gain of the second half of the spectrum against the whole, from first differences: tells bright from dull.
double brightness(const std::vector<double>& x) {
  double steps = 0, energy = 0;
  for (std::size_t n = 1; n < x.size(); ++n)
    steps += (x[n] - x[n - 1]) * (x[n] - x[n - 1]), energy += x[n] * x[n];
  return steps / energy;
}

}  // namespace

TEST_CASE("SplitMix64 gives the published sequence for seed 0") {
  SplitMix stream(0);
  CHECK(stream.bits() == 0xE220A8397B1DCDAFULL);
  CHECK(stream.bits() == 0x6E789E6AA1B965F4ULL);
  CHECK(stream.bits() == 0x06C45D188009454FULL);
  SplitMix again(0);
  CHECK(again.uniform() == static_cast<double>(0xE220A8397B1DCDAFULL >> 11) * 0x1p-53);
}

TEST_CASE("normal draws have mean 0 and variance 1") {
  SplitMix stream(7);
  const std::vector<double> x = stream.normals(200000);
  double mean = 0;
  for (const double v : x) mean += v / 200000;
  CHECK(std::fabs(mean) < 0.01);
  CHECK(rms(x) == doctest::Approx(1).epsilon(0.01));
}

TEST_CASE("DrillBench clip 100 is the clip of the table") {
  const DrillBenchClip clip = drillbench_clip(100, 2.0);
  CHECK(clip.T0 == doctest::Approx(4000));  // 12 Hz
  CHECK(clip.clicks.size() == 24);
  CHECK(clip.envelope.attack_samples == 146);
  CHECK(clip.envelope.decay == doctest::Approx(std::log(10.0) * 40 / 20 / 4000));
  CHECK(rms(clip.clean) == doctest::Approx(1));
  CHECK(rms(drillbench_background(100, 2.0)) == doctest::Approx(1));
  CHECK(drillbench_id(131));
  CHECK_FALSE(drillbench_id(32));
}

TEST_CASE("hard clips hold what their name says") {
  const auto count = [](int id, ClickKind kind) {
    int n = 0;
    for (const SimulatedClick& c : drillbench_clip(id, 2.0).clicks) n += c.kind == kind;
    return n;
  };
  CHECK(count(100, ClickKind::kBounce) == 0);
  CHECK(count(124, ClickKind::kBounce) == count(124, ClickKind::kImpact));
  CHECK(count(127, ClickKind::kDouble) > 0);
}

TEST_CASE("a rate factor moves the strikes and keeps their sound") {
  const DrillBenchClip nominal = drillbench_clip(100, 2.8), faster = drillbench_clip(100, 2.0, 1.4);
  REQUIRE(faster.clicks.size() <= nominal.clicks.size());
  for (std::size_t i = 0; i < faster.clicks.size(); ++i) {
    CHECK(faster.clicks[i].P == std::nearbyint(nominal.clicks[i].P / 1.4));
    CHECK(faster.clicks[i].beta == nominal.clicks[i].beta);
  }
  // The first click sounds alone until the second starts.
  const int n = faster.clicks[1].P - faster.clicks[0].P;
  for (int k = 0; k < n; k += 37)
    CHECK(faster.clean[faster.clicks[0].P + k] ==
          doctest::Approx(nominal.clean[nominal.clicks[0].P + k]).epsilon(1e-6));
}

TEST_CASE("other seeds give other recordings of the same machine") {
  const SituationRecording a = simulate_situation(Situation::kNormal, 1, 6),
                           again = simulate_situation(Situation::kNormal, 1, 6),
                           b = simulate_situation(Situation::kNormal, 2, 6);
  CHECK(a.clean == again.clean);
  CHECK(std::fabs(correlation(a.clean, b.clean)) < 0.05);
  CHECK(brightness(b.clean) == doctest::Approx(brightness(a.clean)).epsilon(0.25));
  CHECK(rms(b.clean) == doctest::Approx(rms(a.clean)).epsilon(0.02));
}

TEST_CASE("situations differ as the design says") {
  const auto make = [](Situation s) { return simulate_situation(s, 3, 8); };
  const SituationRecording normal = make(Situation::kNormal), under = make(Situation::kUnderfeed),
                           over = make(Situation::kOverfeed), closed = make(Situation::kClosedRattling),
                           open = make(Situation::kOpenRattling);
  CHECK(normal.rate_hz >= 35);
  CHECK(normal.rate_hz <= 45);
  CHECK(closed.rate_hz >= 18);
  CHECK(closed.rate_hz <= 25);
  CHECK(over.rate_hz < normal.rate_hz);
  CHECK(under.envelope.attack_samples > 2 * normal.envelope.attack_samples);
  CHECK(brightness(under.clean) < brightness(normal.clean));
  CHECK(brightness(over.clean) < brightness(normal.clean));
  CHECK(brightness(open.clean) > 1.4 * brightness(normal.clean));
  for (const SimulatedPart& burst : open.parts) {
    CHECK(burst.end - burst.start >= 0.45);
    CHECK(burst.end - burst.start <= 1.5);
  }
  CHECK(rms(open.clean) > rms(normal.clean));
  const double expected = 6 * under.rate_hz;
  CHECK(static_cast<double>(under.clicks.size()) < 0.93 * expected);
  for (const SimulatedClick& c : normal.clicks) {
    CHECK(c.P >= kAnalysisRate);
    CHECK(c.P < 7 * kAnalysisRate);
  }
}
