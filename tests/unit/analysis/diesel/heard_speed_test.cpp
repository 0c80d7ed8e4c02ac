// The speed of a diesel from its sound, against the simulated one whose speed is known.
#include "diesel/heard_speed.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "rigsound/analysis/diesel.hpp"
#include "rigsound/machine/input_error.hpp"
#include "simulate/diesel_recording.hpp"
#include "simulate/split_mix.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

std::vector<double> diesel_at(double rpm, double seconds, std::uint64_t seed) {
  DieselRun run;
  run.rpm = steady_rpm(rpm, seconds), run.seed = seed, run.load = static_cast<double>(seed % 5) / 4;
  return simulate_diesel(run).sound;
}

std::string said_at(const std::vector<double>& x, double rpm) {
  DieselTake take;
  take.source = "take.wav", take.mono.assign(x.begin(), x.end()), take.rpm = rpm;
  DieselSettings settings;
  settings.name = "engine";
  try {
    const std::vector<std::string> warnings = learn_diesel({take}, settings).warnings;
    return warnings.empty() ? "" : warnings.front();
  } catch (const InputError& error) {
    return error.what();
  }
}

bool tells(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a diesel's speed is heard within half a per cent, whatever its load" *
          doctest::test_suite("long")) {
  std::uint64_t seed = 0;
  for (double rpm = 560; rpm < 3000; rpm *= 1.11) {
    const HeardSpeed heard = heard_speed(diesel_at(rpm, 15, ++seed));
    CAPTURE(rpm);
    CHECK(heard.rpm == doctest::Approx(rpm).epsilon(0.005));
  }
}

TEST_CASE("of a short recording of a slow diesel the speed is heard, or said to be unsure" *
          doctest::test_suite("long")) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const HeardSpeed heard = heard_speed(diesel_at(480, 8, seed));
    CHECK((heard.confidence < 0.7 || heard.rpm == doctest::Approx(480).epsilon(0.005)));
  }
}

TEST_CASE("noise has no speed") {
  SplitMix draw(1);
  for (int i = 0; i < 10; ++i) CHECK(heard_speed(draw.normals(8 * 48000)).confidence < 0.5);
}

TEST_CASE("a speed that nobody gave is heard and told") {
  const std::string said = said_at(diesel_at(800, 15, 3), 0);
  CHECK(tells(said, "take.wav: rpm: 80"));
  CHECK(tells(said, "is heard"));
  SplitMix draw(1);
  CHECK(tells(said_at(draw.normals(15 * 48000), 0), "expected --rpm"));
}

TEST_CASE("who gives a wrong speed is told the right one" * doctest::test_suite("long")) {
  const std::vector<double> slow = diesel_at(800, 15, 4), fast = diesel_at(1500, 15, 4);
  CHECK(tells(said_at(slow, 900), "repeats at 80"));
  CHECK(tells(said_at(fast, 500), "repeats at 1"));  // a third of it
  CHECK_FALSE(tells(said_at(fast, 1500), "repeats at"));
}
