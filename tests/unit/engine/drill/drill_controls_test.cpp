// The paper's six controls, measured on what is heard.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "engine/drill/flat_bank.hpp"
#include "rigsound/bank_player.hpp"

using namespace rigsound;

TEST_CASE("attack and decay factors turn a click into one with the wanted envelope") {
  const ClickBank bank = flat_bank(50, 0.002);
  for (const float attack : {0.1f, 0.5f, 1.0f, 2.0f, 10.0f})
    for (const float decay : {0.5f, 1.0f, 3.0f}) {
      CAPTURE(attack);
      CAPTURE(decay);
      DrillControls controls;
      controls.attack_factor = attack, controls.decay_factor = decay;
      const std::vector<double> out = one_strike(bank, 0, controls);
      drill::AttackDecay wanted(50.0 * static_cast<double>(attack), 0, 0.002 * static_cast<double>(decay));
      for (int n = 0; n < 2000; ++n) {
        const double expected = 3.0 * wanted.next();
        // the bank's samples are floats
        REQUIRE(out[static_cast<std::size_t>(n)] == doctest::Approx(expected).epsilon(1e-5).scale(1e-3));
      }
    }
}

TEST_CASE("a click made longer still ends 30 dB down, and a bent attack made shorter stays bounded") {
  ClickBank bank = flat_bank(200, 0.002);
  bank.attack_bend = -0.04;  // hardly anything in the first half
  drill::AttackDecay envelope(bank.attack_samples, bank.attack_bend, bank.decay);
  std::vector<float> bent;
  for (int n = 0; n < 3000; ++n) bent.push_back(static_cast<float>(envelope.next()));
  bank.clicks = {bent};
  DrillControls controls;
  controls.attack_factor = 0.2f, controls.decay_factor = 0.25f;
  const std::vector<double> out = one_strike(bank, 0, controls);
  for (std::size_t n = 0; n < 200; ++n)
    CHECK(out[n] <= 10.001 * 3.0 * static_cast<double>(bank.clicks[0][n]) + 1e-12);
  CHECK(out[2999] <= 31.7 * 3.0 * static_cast<double>(bank.clicks[0][2999]));
}

namespace {

/// Mean square over the strikes of a bank of noise clicks, sample by sample after the onset.
std::vector<double> mean_power_course(const DrillControls& controls, std::size_t samples) {
  ClickBank bank = flat_bank(96, 0.004);
  bank.mean_gap_samples = 8000, bank.gap_deviation_samples = 0;
  const Click envelope = bank.clicks[0];
  const dsp::RandomField noise(77, 0, 0);
  bank.clicks.clear();
  for (std::uint64_t c = 0; c < 40; ++c) {
    std::vector<float> click(envelope.begin(), envelope.end());
    for (std::uint64_t n = 0; n < click.size(); ++n)
      click[n] *= static_cast<float>(noise.normal(c * 10000 + n, 0));
    bank.clicks.push_back(click);
  }
  BankPlayer player(bank, 3);
  std::vector<double> sound, power(samples, 0.0), onsets;
  while (sound.size() < 400 * 8000) {
    double out[kChunk];
    player.process(controls, out);
    for (const Impact& impact : player.impacts())
      onsets.push_back(static_cast<double>(sound.size()) + impact.onset);
    sound.insert(sound.end(), out, out + kChunk);
  }
  onsets.pop_back();
  for (const double onset : onsets)
    for (std::size_t n = 0; n < samples; ++n) {
      const double v = sound[static_cast<std::size_t>(std::lround(onset)) + n];
      power[n] += v * v / static_cast<double>(onsets.size());
    }
  return power;
}

/// Least-squares slope of the log amplitude from `first` to `last`: alpha_d of what is heard.
double decay_of(const std::vector<double>& power, std::size_t first, std::size_t last) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double t = static_cast<double>(i), v = 0.5 * std::log(power[i]);
    n += 1, x += t, y += v, xx += t * t, xy += t * v;
  }
  return -(n * xy - x * y) / (n * xx - x * x);
}

/// Samples from the onset to the first block that has reached a quarter of the greatest power, half the
/// amplitude: half the attack, where that is straight.
double half_rise_of(const std::vector<double>& power) {
  constexpr std::size_t kBlock = 8;
  std::vector<double> blocks;
  for (std::size_t n = 0; n + kBlock <= power.size(); n += kBlock) {
    blocks.push_back(0);
    for (std::size_t i = 0; i < kBlock; ++i) blocks.back() += power[n + i];
  }
  const double top = *std::max_element(blocks.begin(), blocks.end());
  const auto half = std::find_if(blocks.begin(), blocks.end(), [&](double b) { return b > top / 4; });
  return static_cast<double>(kBlock) * (static_cast<double>(half - blocks.begin()) + 0.5);
}

}  // namespace

TEST_CASE("what is heard rises in attack-factor times the time and falls at decay-factor times the rate") {
  const auto heard = [](float attack, float decay) {
    DrillControls controls;
    controls.attack_factor = attack, controls.decay_factor = decay;
    return mean_power_course(controls, 1400);
  };
  for (const float decay : {0.5f, 1.0f, 2.0f})
    CHECK(decay_of(heard(1, decay), 150, 1000) ==
          doctest::Approx(0.004 * static_cast<double>(decay)).scale(0).epsilon(0.04));
  for (const float attack : {0.5f, 1.0f, 2.0f, 4.0f})
    CHECK(half_rise_of(heard(attack, 1)) == doctest::Approx(48.0 * static_cast<double>(attack)).epsilon(0.2));
}

TEST_CASE("rate, gain and deviations change what they say and nothing else") {
  const SoundSet sounds = tools::formula_sounds();
  const ClickBank& bank = sounds.banks[0];
  struct Heard {
    std::vector<double> sound, gaps, amplitudes;
  };
  const auto play = [&bank](const DrillControls& controls, int chunks) {
    BankPlayer player(bank, 5);
    Heard heard;
    double last = -1;
    for (int c = 0; c < chunks; ++c) {
      double out[kChunk];
      player.process(controls, out);
      for (const Impact& impact : player.impacts()) {
        const double now = c * kChunk + impact.onset;
        if (last >= 0) heard.gaps.push_back(now - last);
        heard.amplitudes.push_back(impact.amplitude);
        last = now;
      }
      heard.sound.insert(heard.sound.end(), out, out + kChunk);
    }
    return heard;
  };
  const Heard own = play({}, 15000);

  SUBCASE("the rate divides every gap and leaves amplitudes and the first click alone") {
    DrillControls faster;
    faster.mean_frequency_hz = static_cast<float>(1.6 * bank.sample_rate / bank.mean_gap_samples);
    const Heard fast = play(faster, 15000);
    REQUIRE(fast.gaps.size() > 1.5 * static_cast<double>(own.gaps.size()));
    for (std::size_t i = 0; i < own.gaps.size(); ++i) {
      REQUIRE(fast.gaps[i] == doctest::Approx(own.gaps[i] / 1.6).epsilon(1e-6));
      REQUIRE(fast.amplitudes[i] == own.amplitudes[i]);
    }
    for (std::size_t n = 0; n < static_cast<std::size_t>(fast.gaps[0]); ++n)
      REQUIRE(fast.sound[n] == own.sound[n]);
  }
  SUBCASE("the gain multiplies every sample") {
    DrillControls louder;
    louder.mean_amplitude_db = 6;
    const Heard loud = play(louder, 300);
    for (std::size_t n = 0; n < loud.sound.size(); ++n)
      REQUIRE(loud.sound[n] == doctest::Approx(own.sound[n] * std::pow(10, 0.3)).epsilon(1e-9));
  }
  SUBCASE("the deviations scale their own coefficient of variation") {
    const auto variation = [](const std::vector<double>& x) {
      double mean = 0, square = 0;
      for (const double v : x) mean += v / static_cast<double>(x.size());
      for (const double v : x) square += (v - mean) * (v - mean) / static_cast<double>(x.size());
      return std::sqrt(square) / mean;
    };
    const auto plain = [&bank](std::vector<double> gaps) {
      gaps.erase(
          std::remove_if(gaps.begin(), gaps.end(), [&](double g) { return g > 1.6 * bank.mean_gap_samples; }),
          gaps.end());
      return gaps;
    };
    for (const float factor : {0.0f, 0.5f, 2.0f}) {
      DrillControls time, amplitude;
      time.deviation_time = factor, amplitude.deviation_amplitude = factor;
      const Heard in_time = play(time, 60000), in_amplitude = play(amplitude, 60000);
      CHECK(variation(plain(in_time.gaps)) ==
            doctest::Approx(static_cast<double>(factor) * bank.gap_deviation_samples / bank.mean_gap_samples)
                .epsilon(0.06)
                .scale(1e-3));
      CHECK(variation(in_amplitude.amplitudes) ==
            doctest::Approx(static_cast<double>(factor) * bank.amplitude_deviation / bank.mean_amplitude)
                .epsilon(0.06)
                .scale(1e-3));
    }
  }
}
