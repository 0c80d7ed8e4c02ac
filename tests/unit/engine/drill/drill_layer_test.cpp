#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "drill/attack_decay.hpp"
#include "drill/drill_layer.hpp"
#include "engine/drill/flat_bank.hpp"
#include "impact/impact_train.hpp"
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

TEST_CASE("a click rests until half the others have been heard, so all come about equally often") {
  ClickBank bank = flat_bank(0, 0.002);
  bank.clicks.clear();
  for (int i = 0; i < 10; ++i) bank.clicks.push_back({static_cast<float>(i + 1)});
  drill::ClickPlayer player(9, 0, 0);
  std::vector<std::uint64_t> last(10, 0), count(10, 0);
  constexpr std::uint64_t kBlows = 400;
  for (std::uint64_t i = 1; i <= kBlows; ++i) {
    player.strike(bank, {0, 0.5, i}, {});  // B is 2
    double out[kChunk] = {};
    player.add_to(out);
    const auto click = static_cast<std::size_t>(std::lround(out[0])) - 1;
    if (last[click] > 0) REQUIRE(i - last[click] > 5);
    last[click] = i, ++count[click];
  }
  for (const std::uint64_t n : count) CHECK(static_cast<double>(n) == doctest::Approx(40).epsilon(0.3));
}

TEST_CASE("as many banks as may sound at once each remember what they have played") {
  std::vector<ClickBank> banks(drill::kMaxChoices, flat_bank(0, 0.002));
  for (ClickBank& bank : banks) bank.clicks = {{1.0F}, {2.0F}};
  drill::ClickPlayer player(9, 0, 0);
  std::vector<double> last(banks.size(), 0);
  for (std::uint64_t i = 0; i < 40 * banks.size(); ++i) {
    const std::size_t b = i % banks.size();
    player.strike(banks[b], {0, 0.5, i}, {});
    double out[kChunk] = {};
    player.add_to(out);
    REQUIRE(out[0] != last[b]);
    last[b] = out[0];
  }
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
      count += player.impacts().count;
      for (const double x : out) energy += x * x;
    }
    const double own = 48000 / bank.mean_gap_samples;
    const double wanted = rate > 0 ? static_cast<double>(rate) : own;
    const double per_gap = 1 + bank.miss_share;  // a missed strike doubles its gap
    CHECK(count / 60.0 == doctest::Approx(wanted / per_gap).epsilon(0.02));
    // independent clicks of unit norm: energy adds up as rate x E{B^2}
    const double expected = count * (bank.mean_amplitude * bank.mean_amplitude +
                                     bank.amplitude_deviation * bank.amplitude_deviation);
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
  drill::DrillLayer live(11, 0, 48000);
  drill::DrillInput input;
  input.slots[0].banks.add(bank, 1);
  input.slots[0].controls = controls;
  input.slots[0].gain = {1, 1};
  for (int chunk = 0; chunk < 3000; ++chunk) {
    double played[kChunk], heard[kChunk];
    offline.process(controls, played);
    train.process(impact::statistics_of(bank, bank.sample_rate, 0, controls));
    live.process(input, train.impacts(), heard);
    for (int n = 0; n < kChunk; ++n) REQUIRE(played[n] == heard[n]);
  }
}

TEST_CASE("an unusable bank is refused by name when the player is built") {
  ClickBank bank = flat_bank(0, 0.002);
  bank.mean_gap_samples = 0;
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1), doctest::Contains("T0"), std::invalid_argument);
  bank = flat_bank(0, 0.002);
  bank.attack_samples = 100, bank.attack_bend = -1.01;  // exp(101) fills the attack with inf / inf
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1),
                       doctest::Contains("alpha_a: times N_a is -101, expected at least -100"),
                       std::invalid_argument);
  bank.attack_bend = -1;
  CHECK_NOTHROW(BankPlayer(bank, 1));
  bank = flat_bank(0, 0.002);
  bank.gap_correlation = 0.991;
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1), doctest::Contains("r_T: is 0.991, expected -0.99...0.99"),
                       std::invalid_argument);
  bank = flat_bank(0, 0.002);
  std::vector<float> click(bank.clicks[0].begin(), bank.clicks[0].end());
  click[7] = std::nanf("");
  bank.clicks = {click};
  CHECK_THROWS_AS(BankPlayer(bank, 1), std::invalid_argument);
  bank.clicks.clear();
  CHECK_THROWS_WITH_AS(BankPlayer(bank, 1), doctest::Contains("no clicks"), std::invalid_argument);
}

TEST_CASE(
    "the layer says that it sounds as long as a click does, and takes no voice where nothing is heard") {
  const ClickBank bank = flat_bank(0, 0.002);
  drill::DrillLayer layer(1, 0, 48000);
  drill::DrillInput input;
  input.slots[0].banks.add(bank, 1);
  input.slots[0].gain = {1, 1};
  const Impact blow{10, 1, 0};
  double out[kChunk];
  const auto chunks_heard = [&] {
    int chunks = 0;
    while (layer.process(input, {&blow, chunks == 0 ? 1 : 0}, out)) ++chunks;
    return chunks;
  };
  CHECK_FALSE(layer.process(input, {}, out));
  CHECK(chunks_heard() == (10 + 2000 + kChunk - 1) / kChunk);
  CHECK_FALSE(layer.process(input, {}, out));
  input.slots[0].gain = {0, 0};
  CHECK(chunks_heard() == 0);
  input.slots[0].gain = {1, 0};  // it fades in this very chunk: what begins in it is never heard
  CHECK(chunks_heard() == 0);
  input.slots[0].gain = {0, 1};
  CHECK(chunks_heard() > 0);
  input.slots[0].banks = {};
  CHECK(chunks_heard() == 0);
}
