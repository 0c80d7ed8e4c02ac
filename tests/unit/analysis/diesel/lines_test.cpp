// Tones off the orders of a simulated diesel: found, measured, taken off; none where there is none.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "diesel/free_lines.hpp"
#include "diesel/order_analysis.hpp"
#include "diesel/section.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "simulate/diesel_recording.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

constexpr double kOrder = 22.14, kFixed_hz = 1234, kLevel = 0.01, kSeconds = 10;
constexpr int kAngles = 2048;

enum class Tones { kNone, kOdd, kSteady, kBoth };

DieselRecording diesel_with(Tones tones, double rpm, unsigned seed = 1) {
  DieselRun run;
  run.rpm = steady_rpm(rpm, kSeconds), run.seed = seed;
  DieselRecording diesel = simulate_diesel(run);
  const double order = tones == Tones::kOdd || tones == Tones::kBoth ? kLevel : 0;
  const double fixed = tones == Tones::kSteady || tones == Tones::kBoth ? kLevel : 0;
  for (std::size_t n = 0; n < diesel.sound.size(); ++n)
    diesel.sound[n] += order * std::cos(2 * M_PI * kOrder * diesel.theta[n]) +
                       fixed * std::cos(2 * M_PI * kFixed_hz * static_cast<double>(n) / kAnalysisRate);
  return diesel;
}

/// The section of a diesel whose crank is known, its mean cycle taken off.
Section residual_of(const DieselRecording& diesel) {
  Section s;
  s.x = diesel.sound, s.theta = diesel.theta;
  const CycleBlock block = cycles_of(s, s.x, 0, kAngles);
  const std::vector<double> cycle = mean_cycle(block, 0, block.cycles);
  for (std::size_t n = 0; n < s.x.size(); ++n) {
    const double at = (s.theta[n] - std::floor(s.theta[n])) * kAngles;
    const auto i = static_cast<std::size_t>(at);
    const double a = cycle[i % kAngles], b = cycle[(i + 1) % kAngles];
    s.x[n] -= a + (b - a) * (at - static_cast<double>(i));
  }
  return s;
}

std::vector<DieselOscillator> tones_of(const std::vector<Section>& sections) {
  std::vector<SectionResidual> residuals;
  for (const Section& s : sections) residuals.push_back({&s, &s.x});
  std::vector<DieselOscillator> tones;
  for (const FreeLine& line : free_lines(residuals, kAngles)) tones.push_back(line.tone);
  return tones;
}

double cents(double a, double b) { return 1200 * std::fabs(std::log2(a / b)); }
double db(double a, double b) { return 20 * std::fabs(std::log10(a / b)); }

void check_both(const std::vector<DieselOscillator>& tones) {
  REQUIRE(tones.size() == 2);
  CHECK(tones[0].order_locked != tones[1].order_locked);
  for (const DieselOscillator& tone : tones) {
    CHECK(cents(tone.frequency, tone.order_locked ? kOrder : kFixed_hz) < 1);
    CHECK(db(tone.amplitude, kLevel) < 1);
  }
}

/// Amplitude of the odd order over all of the section.
double amplitude_at_order(const Section& s, const std::vector<double>& x) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < x.size(); ++n) sum += x[n] * std::polar(1.0, -2 * M_PI * kOrder * s.theta[n]);
  return 2 * std::abs(sum) / static_cast<double>(x.size());
}

}  // namespace

TEST_CASE("a tone at an odd order and one at a fixed pitch are told apart at one speed and at two") {
  const Section slow = residual_of(diesel_with(Tones::kBoth, 900)),
                fast = residual_of(diesel_with(Tones::kBoth, 1310));
  check_both(tones_of({slow}));
  check_both(tones_of({slow, fast}));
}

TEST_CASE("a line that only one of two speeds has stays in the noise") {
  const Section with = residual_of(diesel_with(Tones::kOdd, 900)),
                without = residual_of(diesel_with(Tones::kNone, 1310));
  CHECK(tones_of({with}).size() == 1);
  CHECK(tones_of({with, without}).empty());
}

TEST_CASE("a diesel alone has no free lines") {
  for (const double rpm : {900.0, 1700.0}) {
    CAPTURE(rpm);
    CHECK(tones_of({residual_of(diesel_with(Tones::kNone, rpm, 3))}).empty());
  }
}

TEST_CASE("a line is taken off by more than 15 dB") {
  const Section s = residual_of(diesel_with(Tones::kOdd, 900));
  const std::vector<double> left = without_line(s, s.x, kOrder, Lock::kCrank);
  CHECK(amplitude_at_order(s, left) < amplitude_at_order(s, s.x) * std::pow(10, -15.0 / 20));
}

TEST_CASE("learning a diesel with a fixed tone beside it gives the model that tone") {
  const DieselRecording diesel = diesel_with(Tones::kSteady, 900);
  DieselTake take;
  take.source = "take.wav", take.mono.assign(diesel.sound.begin(), diesel.sound.end()), take.rpm = 900;
  DieselSettings settings;
  settings.name = "engine";
  const DieselModel model = learn_diesel({take}, settings).model;
  REQUIRE(model.oscillators.size() == 1);
  CHECK_FALSE(model.oscillators.front().order_locked);
  CHECK(cents(model.oscillators.front().frequency, kFixed_hz) < 1);
  CHECK(db(model.oscillators.front().amplitude, kLevel) < 1);
}
