#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "drill/attack_decay.hpp"
#include "drill/click_player.hpp"
#include "drill/drill_layer.hpp"
#include "rigsound/bank_player.hpp"

using namespace rigsound;

TEST_CASE("the envelope is eq. 5 and 6 of the drilling paper") {
  const double N_a = 40, alpha_d = 0.003;
  for (const double alpha_a : {0.0, 0.05, -0.04}) {
    drill::AttackDecay envelope(N_a, alpha_a, alpha_d);
    for (int n = 0; n < 400; ++n) {
      const double rise = alpha_a == 0 ? n / N_a : std::expm1(-alpha_a * n) / std::expm1(-alpha_a * N_a);
      const double expected = n <= N_a ? rise : std::exp(-(n - N_a) * alpha_d);
      REQUIRE(envelope.next() == doctest::Approx(expected).epsilon(1e-12));
    }
  }
}

namespace {

ClickBank flat_bank(double N_a, double alpha_d) {
  ClickBank bank;
  bank.T_0 = 4800, bank.B = 2, bank.N_a = N_a, bank.alpha_d = alpha_d;
  std::vector<float> click;
  drill::AttackDecay envelope(N_a, 0, alpha_d);
  for (int n = 0; n < 2000; ++n) click.push_back(static_cast<float>(envelope.next()));
  bank.clicks = {click};
  return bank;
}

std::vector<double> one_strike(const ClickBank& bank, double onset, const DrillControls& controls) {
  drill::ClickPlayer player(1, 0, 0);
  player.strike(bank, {onset, 1.5, 0}, controls);
  std::vector<double> out(3200, 0.0);
  for (std::size_t n = 0; n < out.size(); n += kChunk) player.add_to(&out[n]);
  return out;
}

}  // namespace

TEST_CASE("a click sounds at its rounded onset with amplitude B times the blow's") {
  const ClickBank bank = flat_bank(0, 0.002);
  for (const double onset : {0.0, 3.4, 31.7}) {
    const std::vector<double> out = one_strike(bank, onset, {});
    const auto start = static_cast<std::size_t>(std::floor(onset + 0.5));
    for (std::size_t n = 0; n < start; ++n) CHECK(out[n] == 0);
    CHECK(out[start] == doctest::Approx(3.0 * static_cast<double>(bank.clicks[0][0])));
    CHECK(out[start + 500] == doctest::Approx(3.0 * static_cast<double>(bank.clicks[0][500])));
    CHECK(out[start + 2000] == 0);
  }
}

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
  bank.clicks[0].clear();
  bank.alpha_a = -0.04;  // hardly anything in the first half
  drill::AttackDecay envelope(bank.N_a, bank.alpha_a, bank.alpha_d);
  for (int n = 0; n < 3000; ++n) bank.clicks[0].push_back(static_cast<float>(envelope.next()));
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
  bank.T_0 = 8000, bank.sigma_T = 0;
  const std::vector<float> envelope = bank.clicks[0];
  const dsp::RandomField noise(77, 0, 0);
  bank.clicks.assign(40, envelope);
  for (std::uint64_t c = 0; c < bank.clicks.size(); ++c)
    for (std::uint64_t n = 0; n < envelope.size(); ++n)
      bank.clicks[c][n] *= static_cast<float>(noise.normal(c * 10000 + n, 0));
  BankPlayer player(bank, 3);
  std::vector<double> sound, power(samples, 0.0), onsets;
  while (sound.size() < 400 * 8000) {
    double out[kChunk];
    player.process(controls, out);
    for (int i = 0; i < player.impact_count(); ++i)
      onsets.push_back(static_cast<double>(sound.size()) + player.impacts()[i].onset);
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
          doctest::Approx(0.004 * static_cast<double>(decay)).epsilon(0.04));
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
      for (int i = 0; i < player.impact_count(); ++i) {
        const double now = c * kChunk + player.impacts()[i].onset;
        if (last >= 0) heard.gaps.push_back(now - last);
        heard.amplitudes.push_back(player.impacts()[i].amplitude);
        last = now;
      }
      heard.sound.insert(heard.sound.end(), out, out + kChunk);
    }
    return heard;
  };
  const Heard own = play({}, 15000);

  SUBCASE("the rate divides every gap and leaves amplitudes and the first click alone") {
    DrillControls faster;
    faster.mean_frequency_hz = static_cast<float>(1.6 * bank.sample_rate / bank.T_0);
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
      gaps.erase(std::remove_if(gaps.begin(), gaps.end(), [&](double g) { return g > 1.6 * bank.T_0; }),
                 gaps.end());
      return gaps;
    };
    for (const float factor : {0.0f, 0.5f, 2.0f}) {
      DrillControls time, amplitude;
      time.deviation_time = factor, amplitude.deviation_amplitude = factor;
      const Heard in_time = play(time, 60000), in_amplitude = play(amplitude, 60000);
      CHECK(variation(plain(in_time.gaps)) ==
            doctest::Approx(static_cast<double>(factor) * bank.sigma_T / bank.T_0).epsilon(0.06).scale(1e-3));
      CHECK(variation(in_amplitude.amplitudes) ==
            doctest::Approx(static_cast<double>(factor) * bank.sigma_B / bank.B).epsilon(0.06).scale(1e-3));
    }
  }
}

TEST_CASE("the same click never comes twice in a row, and all come") {
  ClickBank bank = flat_bank(0, 0.002);
  bank.clicks.clear();
  for (int i = 1; i <= 4; ++i) bank.clicks.push_back({static_cast<float>(i)});
  drill::ClickPlayer player(9, 0, 0);
  double last = 0;
  std::set<double> heard;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    player.strike(bank, {0, 1, i}, {});
    double out[kChunk] = {};
    player.add_to(out);
    REQUIRE(out[0] != last);
    last = out[0];
    heard.insert(last);
  }
  CHECK(heard.size() == 4);
}

TEST_CASE("clicks beyond the last voice are counted, not stacked") {
  const ClickBank bank = flat_bank(0, 0.002);
  drill::ClickPlayer player(9, 0, 0);
  for (std::uint64_t i = 0; i < kMaxVoices + 5; ++i) player.strike(bank, {0, 1, i}, {});
  CHECK(player.lost() == 5);
}

TEST_CASE("a bank plays at its own mean rate and level, and at the rate it is asked for") {
  const SoundSet sounds = tools::formula_sounds();
  const ClickBank& bank = sounds.banks[0];
  for (const float rate : {0.0f, 20.0f, 60.0f}) {
    BankPlayer player(bank, 5);
    DrillControls controls;
    controls.mean_frequency_hz = rate;
    int count = 0;
    double energy = 0;
    constexpr int kChunks = 48000 * 60 / kChunk;
    for (int i = 0; i < kChunks; ++i) {
      double out[kChunk];
      player.process(controls, out);
      count += player.impact_count();
      for (const double x : out) energy += x * x;
    }
    const double own = 48000 / bank.T_0;
    const double wanted = rate > 0 ? static_cast<double>(rate) : own;
    const double per_gap = 1 + bank.p_miss;  // a missed strike doubles its gap
    CHECK(count / 60.0 == doctest::Approx(wanted / per_gap).epsilon(0.02));
    // independent clicks of unit norm: energy adds up as rate x E{B^2}
    const double expected = count * (bank.B * bank.B + bank.sigma_B * bank.sigma_B);
    CHECK(energy == doctest::Approx(expected).epsilon(0.05));
  }
}

TEST_CASE("a bank played offline has the samples a boom plays live") {
  const SoundSet sounds = tools::formula_sounds();
  const ClickBank& bank = sounds.banks[0];
  DrillControls controls;
  controls.decay_factor = 1.5f, controls.mean_amplitude_db = -3;
  BankPlayer offline(bank, 11);
  impact::ImpactTrain train(11, 0);
  drill::DrillLayer live(11, 0);
  std::array<scene::Slot, kSituationCount> slots{};
  slots[0] = {&bank, 1, 1};
  for (int chunk = 0; chunk < 3000; ++chunk) {
    double played[kChunk], heard[kChunk];
    offline.process(controls, played);
    train.process(impact::statistics_of(bank, bank.sample_rate, 0, controls));
    live.process(slots, controls, train, heard);
    for (int n = 0; n < kChunk; ++n) REQUIRE(played[n] == heard[n]);
  }
}

TEST_CASE("an unusable bank is refused by name when the player is built") {
  ClickBank bank = flat_bank(0, 0.002);
  bank.T_0 = 0;
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1), doctest::Contains("T0"), std::invalid_argument);
  bank = flat_bank(0, 0.002);
  bank.clicks[0][7] = std::nanf("");
  CHECK_THROWS_AS(BankPlayer(bank, 1), std::invalid_argument);
  bank.clicks.clear();
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1), doctest::Contains("no clicks"), std::invalid_argument);
}
