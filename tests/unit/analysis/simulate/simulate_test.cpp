#include <doctest/doctest.h>

#include <cmath>
#include <utility>

#include "bank/third_octave.hpp"
#include "rigsound/analysis/rate.hpp"
#include "simulate/drillbench_clip.hpp"
#include "simulate/drilling_click.hpp"
#include "simulate/drilling_recording.hpp"
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
  // Pressed too hard: 3 to 8 % slower, steadier, short and dull.
  CHECK(over.rate_hz > 0.92 * normal.rate_hz);
  CHECK(over.rate_hz < 0.97 * normal.rate_hz);
  CHECK(over.process.jitter < 0.5 * normal.process.jitter);
  CHECK(over.process.amplitude_cv < 0.5 * normal.process.amplitude_cv);
  CHECK(over.envelope.decay > 1.5 * normal.envelope.decay);
  CHECK(brightness(over.clean) < 0.6 * brightness(normal.clean));
  // Hardly pressed: irregular, 10 to 15 % missing, long and bright.
  CHECK(under.process.jitter > 1.5 * normal.process.jitter);
  CHECK(under.process.amplitude_cv > 1.5 * normal.process.amplitude_cv);
  CHECK(under.envelope.decay < 0.7 * normal.envelope.decay);
  CHECK(brightness(under.clean) > 1.3 * brightness(normal.clean));
  const double expected = 6 * under.rate_hz;
  CHECK(static_cast<double>(under.clicks.size()) < 0.93 * expected);
  CHECK(static_cast<double>(under.clicks.size()) > 0.80 * expected);

  CHECK(brightness(open.clean) > 1.4 * brightness(normal.clean));
  for (const SimulatedPart& burst : open.parts) {
    CHECK(burst.end - burst.start >= 0.45);
    CHECK(burst.end - burst.start <= 1.5);
  }
  CHECK(rms(open.clean) > rms(normal.clean));
  for (const SimulatedClick& c : normal.clicks) {
    CHECK(c.P >= kAnalysisRate);
    CHECK(c.P < 7 * kAnalysisRate);
  }
}

namespace {

/// Third-octave distance of 1: the whole difference, and 2: what is left without that of the levels.
std::pair<double, double> distances_db(const std::vector<double>& a, const std::vector<double>& b) {
  const auto levels = [](const std::vector<double>& x) {
    return third_octave_levels(std::vector<float>(x.begin(), x.end()));
  };
  const BandLevels first = levels(a), second = levels(b);
  return {mean_difference_db(first, second, 200, Difference::kAbsolute),
          mean_difference_db(first, second, 200, Difference::kCentred)};
}

std::vector<double> recorded(const SituationRecording& r) {
  std::vector<double> x = r.clean;
  for (std::size_t n = 0; n < x.size(); ++n) x[n] += r.background[n];
  return x;
}

}  // namespace

TEST_CASE("any two situations are 3 dB of third-octave levels or 5 % of rate apart, background and all" *
          doctest::test_suite("long")) {
  for (const std::uint64_t seed : {1, 8}) {
    std::vector<SituationRecording> all;
    for (int i = 0; i < kSituationCount; ++i)
      all.push_back(simulate_situation(static_cast<Situation>(i), seed, 6));
    for (const SituationRecording& a : all)
      for (const SituationRecording& b : all) {
        if (&a == &b) continue;
        const auto distances = distances_db(recorded(a), recorded(b));
        const double absolute = distances.first, centred = distances.second;
        const double rates = std::fabs(std::log(a.rate_hz / b.rate_hz));
        INFO(name(a.situation), " and ", name(b.situation), ": ", absolute, " dB, ", centred, " dB, rate ",
             rates);
        CHECK((absolute >= 3 || rates >= 0.05));
        CHECK((centred >= 3 || rates >= 0.05));
      }
  }
}

TEST_CASE("along the feed the clicks follow the laws: norm, spacing and decay, rods shift them" *
          doctest::test_suite("long")) {
  const DrillingLaws laws(5);
  const auto made = [&](double feed_bar, int rods) {
    DrillingCourse course;
    course.start_feed_bar = course.end_feed_bar = feed_bar;
    course.rods = rods, course.seconds = 12;
    return simulate_drilling(course, laws, {5, 0});
  };
  for (const double feed : {40.0, 90.0, 165.0})
    for (const int rods : {1, 3}) {
      const DrillingPoint p = laws.at(feed, rods);
      const DrillingRecording r = made(feed, rods);
      const double drilled_s = 10, made_hz = static_cast<double>(r.clicks.size()) / drilled_s;
      const double chance =
          4 * std::sqrt(p.miss_share * (1 - p.miss_share) / static_cast<double>(r.clicks.size()));
      CHECK(made_hz == doctest::Approx(p.rate_hz * (1 - p.miss_share)).epsilon(chance + 0.01));
      const double mean_square =
          p.norm * p.norm * (1 + p.norm_variation * p.norm_variation) * made_hz / 48000;
      CHECK(rms(r.clean) * std::sqrt(12 / drilled_s) ==
            doctest::Approx(std::sqrt(mean_square)).epsilon(0.03));
    }
  // The slopes are those of the points.
  const FeedLaws slopes = DrillingLaws::slopes();
  const DrillingPoint a = laws.at(60, 1), b = laws.at(100, 1);
  CHECK(std::log(a.rate_hz / b.rate_hz) / 40 == doctest::Approx(slopes.ln_gap));
  CHECK(std::log(b.norm / a.norm) / 40 == doctest::Approx(slopes.ln_level));
  CHECK(std::log(b.decay / a.decay) / 40 == doctest::Approx(slopes.ln_decay));
  CHECK((b.tilt_db_per_octave - a.tilt_db_per_octave) / 40 == doctest::Approx(slopes.tilt_db_per_octave));
  CHECK(brightness_hz(a, 1) > 1.2 * brightness_hz(b, 1));
  CHECK(a.miss_share > b.miss_share);
}

TEST_CASE("a click of the drill has norm one and decays as its law says") {
  const DrillingPoint p = DrillingLaws(1).at(120, 1);
  DrillingClicks clicks(1, 3, 4);
  // Mean energies of 200 clicks in two windows of 5 ms, 15 ms apart.
  double early = 0, late = 0, energy = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> click = clicks.draw(p);
    for (std::size_t n = 240; n < 480; ++n) early += click[n] * click[n];
    for (std::size_t n = 960; n < 1200; ++n) late += click[n] * click[n];
    for (const double v : click) energy += v * v;
  }
  CHECK(energy == doctest::Approx(200));
  CHECK(std::log(early / late) / 2 / 720 == doctest::Approx(p.decay).epsilon(0.02));
}
