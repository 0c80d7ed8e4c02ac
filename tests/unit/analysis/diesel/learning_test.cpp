// Learning an engine, against the simulated diesel whose crank and body are known.
#include <doctest/doctest.h>

#include <cmath>

#include "diesel/crank_tracker.hpp"
#include "diesel/cycle_length.hpp"
#include "diesel/phase_advance.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/machine/input_error.hpp"
#include "simulate/diesel_recording.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

DieselRecording engine_at(double rpm, double seconds) {
  DieselRun run;
  run.rpm = steady_rpm(rpm, seconds);
  return simulate_diesel(run);
}

DieselTake take_of(const std::vector<double>& x, double rpm) {
  DieselTake take;
  take.source = "take.wav", take.mono.assign(x.begin(), x.end()), take.rpm = rpm;
  return take;
}

void check_refused(const DieselTake& take, const char* word) {
  DieselSettings settings;
  settings.name = "engine";
  CHECK_THROWS_WITH_AS(learn_diesel({take}, settings), doctest::Contains(word), InputError);
}

}  // namespace

TEST_CASE("the crank angle of a simulated diesel is found to a degree") {
  const DieselRecording truth = engine_at(1200, 8);
  const CrankTrack track = track_steady(truth.sound, 1200);
  REQUIRE(track.theta.size() > 300000);
  double mean = 0, square = 0;
  for (std::size_t n = 0; n < track.theta.size(); ++n) {
    const double away = track.theta[n] - truth.theta[track.first + n];
    mean += away / static_cast<double>(track.theta.size());
    square += away * away / static_cast<double>(track.theta.size());
  }
  CHECK(720 * std::sqrt(square - mean * mean) < 1);
}

TEST_CASE("what cannot be an engine at that speed is refused") {
  const DieselRecording engine = engine_at(1200, 4);
  check_refused(take_of(engine.sound, 1270), "within 3 %");
  check_refused(take_of({engine.sound.begin(), engine.sound.begin() + 72000}, 1200), "20");
  SplitMix draw(1);
  check_refused(take_of(draw.normals(192000), 1200), "take.wav");
}

TEST_CASE("twice the true speed is refused: every other of its cycles differs; the true speed is not") {
  const DieselRecording engine = engine_at(650, 10);
  check_refused(take_of(engine.sound, 1300), "expected 650 r/min");
  DieselSettings settings;
  settings.name = "engine";
  CHECK(learn_diesel({take_of(engine.sound, 650)}, settings).warnings.size() == 1);  // few cycles
}

TEST_CASE("the halves of a cycle are alike at half the true speed, and only there") {
  const DieselRecording engine = engine_at(650, 20);
  Section s;
  s.x = engine.sound, s.theta = engine.theta;
  const Alternation right = alternation_of(s);
  CHECK(right.halves > 4);
  CHECK(right.cycles < 2);
  for (double& theta : s.theta) theta /= 2;
  const Alternation halved = alternation_of(s);
  CHECK(halved.halves < 1.5);
  CHECK(halved.quarters > 10);
}

TEST_CASE("a phase that was advanced comes out of the crossover's high-pass in place") {
  std::vector<double> x(48000, 0.0);
  x[20000] = 1;
  x = phase_advanced(x, 300);
  dsp::Butterworth6 filter(dsp::Pass::kHigh, 300, kAnalysisRate);
  for (double& v : x) v = filter.process(v);
  for (std::size_t lag = 1; lag < 2000; ++lag) CHECK(std::fabs(x[20000 + lag] - x[20000 - lag]) < 1e-6);
}
