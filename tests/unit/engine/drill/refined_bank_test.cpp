// The six controls worked into a bank: what it says of itself, and what its clicks are.
#include "rigsound/refined_bank.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "engine/drill/flat_bank.hpp"
#include "rigsound/machine/fields.hpp"

using namespace rigsound;

namespace {

ClickBank bank() {
  ClickBank bank = flat_bank(96, 0.01);
  bank.gap_deviation_samples = 240;
  bank.amplitude_deviation = 0.4;
  bank.gain_db = -2;
  return bank;
}

double energy_of(const Click& click) {
  double sum = 0;
  for (const float x : click) sum += static_cast<double>(x) * static_cast<double>(x);
  return sum;
}

}  // namespace

TEST_CASE("neutral controls leave a bank as it is") {
  const ClickBank before = bank(), after = refined_bank(before, DrillControls{});
  CHECK(after.clicks == before.clicks);
  CHECK(after.mean_gap_samples == before.mean_gap_samples);
  CHECK(after.gap_deviation_samples == doctest::Approx(240));
  CHECK(after.mean_amplitude == before.mean_amplitude);
  CHECK(after.amplitude_deviation == before.amplitude_deviation);
  CHECK(after.gain_db == before.gain_db);
  CHECK(after.decay == before.decay);
}

TEST_CASE("rate, level and scatter are what the controls say, the clicks stay") {
  DrillControls controls;
  controls.mean_frequency_hz = 40, controls.deviation_time = 3;
  controls.mean_amplitude_db = 6, controls.deviation_amplitude = 0.5F;
  const ClickBank after = refined_bank(bank(), controls);
  CHECK(after.mean_gap_samples == doctest::Approx(48000 / 40.0));
  CHECK(after.gap_deviation_samples / after.mean_gap_samples == doctest::Approx(3 * 240 / 4800.0));
  CHECK(after.gain_db == doctest::Approx(4));
  CHECK(after.amplitude_deviation == doctest::Approx(0.2));
  CHECK(after.mean_amplitude == 2);
  CHECK(after.clicks == bank().clicks);
  CHECK(after.attack_samples == 96);
}

TEST_CASE("attack and decay give clicks of unit energy, their level goes to the mean amplitude") {
  for (const auto& [attack, decay] : {std::pair{1.0, 2.0}, {2.0, 1.0}, {0.5, 0.75}}) {
    DrillControls controls;
    controls.attack_factor = static_cast<float>(attack), controls.decay_factor = static_cast<float>(decay);
    const ClickBank before = bank(), after = refined_bank(before, controls);
    CAPTURE(controls.attack_factor);
    CAPTURE(controls.decay_factor);
    CHECK(after.attack_samples == doctest::Approx(96 * attack));
    CHECK(after.decay == doctest::Approx(0.01 * decay));
    REQUIRE(after.clicks.size() == 1);
    REQUIRE(after.clicks[0].size() == before.clicks[0].size());
    CHECK(energy_of(after.clicks[0]) == doctest::Approx(1).epsilon(1e-6));
    CHECK(after.amplitude_deviation / after.mean_amplitude == doctest::Approx(0.2));
    // What is heard is the wanted envelope, as loud as the blow was.
    drill::AttackDecay wanted(96 * attack, 0, 0.01 * decay);
    for (const float x : after.clicks[0]) {
      const double heard = after.mean_amplitude * static_cast<double>(x);
      REQUIRE(heard == doctest::Approx(2 * wanted.next()).scale(1).epsilon(1e-3));
    }
  }
}

TEST_CASE("a bend grows as the attack shortens, the mean of the clicks' energies is what is moved") {
  ClickBank two = bank();
  two.attack_bend = 0.02;
  std::vector<float> half(two.clicks[0].begin(), two.clicks[0].end());
  for (float& x : half) x *= 0.5F;
  two.clicks.emplace_back(half);
  DrillControls controls;
  controls.attack_factor = 0.5F;
  const ClickBank after = refined_bank(two, controls);
  CHECK(after.attack_bend == doctest::Approx(0.04));
  ClickBank first = two, second = two;
  first.clicks = {two.clicks[0]}, second.clicks = {two.clicks[1]};
  const double a = refined_bank(first, controls).mean_amplitude / 2,
               b = refined_bank(second, controls).mean_amplitude / 2;
  CHECK(b == doctest::Approx(a / 2));
  CHECK(after.mean_amplitude / 2 == doctest::Approx(std::sqrt((a * a + b * b) / 2)));
  for (const Click& click : after.clicks) CHECK(energy_of(click) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("a click without energy stays silent, a bank that cannot be played is refused") {
  ClickBank silent = bank();
  silent.clicks = {silent.clicks[0], std::vector<float>(100, 0.0F)};
  DrillControls controls;
  controls.decay_factor = 2;
  const ClickBank after = refined_bank(silent, controls);
  CHECK(energy_of(after.clicks[1]) == 0);
  ClickBank none = bank();
  none.clicks.clear();
  CHECK_THROWS_AS(refined_bank(none, DrillControls{}), InvalidField);
}

TEST_CASE("a click is reshaped to its last sample, whatever its length") {
  for (const std::size_t length : {1UL, 63UL, 64UL, 65UL, 129UL, 200UL}) {
    ClickBank even = bank();
    even.attack_samples = 0, even.decay = 1e-3;
    even.clicks = {std::vector<float>(length, 0.1F)};
    DrillControls controls;
    controls.decay_factor = 2;
    const ClickBank after = refined_bank(even, controls);
    CAPTURE(length);
    REQUIRE(after.clicks[0].size() == length);
    // e^(-2 n / 1000) instead of e^(-n / 1000)
    const double first = static_cast<double>(after.clicks[0][0]),
                 last = static_cast<double>(after.clicks[0][length - 1]);
    CHECK(last / first == doctest::Approx(std::exp(-1e-3 * static_cast<double>(length - 1))).epsilon(1e-5));
  }
}
