// The drill string as a whole: passive, monotone in the feed, calm when it is changed, the same everywhere.
#include "string/string_layer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/allocation_guard.hpp"
#include "engine/heard.hpp"
#include "engine/string/string_sounds.hpp"
#include "string/design/string_tuning.hpp"
#include "string/longitudinal_string.hpp"

using namespace rigsound;
using namespace rigsound::string;
using namespace rigsound::tests;

namespace {

StringInput drilling(int rods = 1, double rock = 2e8, double contact = 1) {
  StringInput input;
  input.rods = rods;
  input.rock_stiffness = rock;
  input.contact = contact;
  return input;
}

std::vector<double> rendered(const StringModel& model, const StringInput& input, std::uint64_t seed = 1,
                             double seconds = 1) {
  StringLayer layer(model, kStringRate, seed, 0);
  return struck(layer, {seconds}, [&](double) { return input; });
}

}  // namespace

TEST_CASE("the bit sends back what a loading spring that unloads stiffly leaves, within a hundredth") {
  CHECK(largest_reflection_error(9) <= 0.01);
  CHECK(largest_reflection_error(16) <= 0.003);
}

TEST_CASE("a bit in the air sends everything back as tension, one in a gap what comes before it is crossed") {
  const auto reflected = [](double gap) {
    BitContact bit;
    bit.set_loading(9);
    bit.set_gap(gap);
    bit.silence();
    double down[kChunk];
    std::vector<double> up(kChunk);
    for (int n = 0; n < kChunk; ++n) down[n] = n < 9;
    bit.process(down, up.data(), kChunk);
    return up;
  };
  // A free end moves by twice the force: ten units are crossed by five samples of the pulse, eighteen by all.
  const auto air = reflected(-1), wide = reflected(18.5), narrow = reflected(10);
  for (int n = 0; n < kChunk; ++n) {
    CHECK(air[n] == (n < 9 ? -1 : 0));
    CHECK(wide[n] == air[n]);
    if (n < 5) CHECK(narrow[n] == -1);
    if (n >= 5 && n < 9) CHECK(narrow[n] > (n == 5 ? -1 : narrow[n - 1]));
  }
}

TEST_CASE("a bit that tension has pulled off the rock comes back as far as it went, at most the gap") {
  for (const int tension : {1, 2, 4, 5, 8}) {
    BitContact bit;
    bit.set_loading(9);
    bit.set_gap(10);
    bit.silence();
    double down[kChunk], up[kChunk];
    for (int n = 0; n < kChunk; ++n) down[n] = n >= 8 && n < 8 + tension ? -1 : 1;
    bit.process(down, up, kChunk);
    // It moves by two units a sample: with the gap of ten no further than five samples do.
    const int lands = 8 + tension + std::min(tension, 5);
    CAPTURE(tension);
    for (int n = 9; n < lands; ++n) CHECK(up[n] == -down[n]);
    CHECK(up[lands] > -1);
  }
}

TEST_CASE("a bit gives as many samples as it is given, in the air, on the rock and in a gap") {
  for (const double gap : {-1.0, 0.0, 10.0}) {
    BitContact bit;
    bit.set_loading(9);
    bit.set_gap(gap);
    bit.silence();
    double down[kChunk] = {1, 1, 1, 1, 1, 1, 1, 1, 1}, up[kChunk];
    std::fill(up, up + kChunk, 7.0);
    bit.process(down, up, 8);
    CAPTURE(gap);
    CHECK(up[7] != 7);
    CHECK(std::all_of(up + 8, up + kChunk, [](double x) { return x == 7; }));
  }
}

TEST_CASE("without blows no energy is made, whatever stiffness, gap, length and contact do") {
  for (const dsp::LaneWidth width : {dsp::LaneWidth::kTwo, dsp::widest_lanes()}) {
    CHECK(largest_string_growth(plain_string(1.83, 0.038, 3), 4000, width) <= 1e-13);
    CHECK(largest_string_growth(plain_string(0.6, 0.038, 3), 4000, width) <= 1e-13);
    CHECK(largest_bending_growth(plain_string(3.66), 4000, width) <= 1e-13);
  }
}

TEST_CASE("nor is any by fractions of a sample in a string that loses next to nothing at the shank") {
  StringModel model = bare_string(1, 3);
  model.sleeve_impedance = 1.0001;  // reflects nothing to speak of
  REQUIRE(tune_string(model, 3, kStringRate).has_fractions);
  CHECK(largest_string_growth(model, 4000, dsp::widest_lanes()) <= 1e-13);
}

TEST_CASE("between its losses at the shank a string keeps its energy, wherever the waves are") {
  for (const int rods : {1, 3}) {
    const StringModel model = bare_string(3.66, rods);
    const StringTuning tuning = tune_string(model, rods, kStringRate);
    REQUIRE(tuning.loss_side == 0);
    const double lost = 1 - tuning.loss_middle * tuning.loss_middle;  // of what the shank reflects
    LongitudinalString line(model, kStringRate, dsp::widest_lanes());
    line.bit().set_gap(-1);
    double in[kChunk] = {1, -0.5, 2, 1}, none[kChunk] = {}, heard[kChunk];
    line.process({in, none, heard});
    const double first = line.energy();
    CHECK(first == doctest::Approx(1 + 0.25 + 4 + 1).epsilon(1e-12));
    for (int chunk = 1; chunk < 300; ++chunk) {
      line.process({none, none, heard});
      const double trips = chunk * kChunk / tuning.round_trip();
      CAPTURE(chunk);
      CHECK(line.energy() <= first * std::pow(1 - lost, std::floor(trips) - 1));
      CHECK(line.energy() >= first * std::pow(1 - lost, std::ceil(trips) + 1));
    }
  }
}

TEST_CASE("a string at rest holds no energy, with sleeves and fractions of a sample too") {
  const StringModel model = plain_string(1.83, 0.038, 3);
  REQUIRE(tune_string(model, 3, kStringRate).has_fractions);
  CHECK(LongitudinalString(model, kStringRate, dsp::widest_lanes()).energy() == 0);
}

TEST_CASE("the wider the gap the feed leaves, the more the string rings on") {
  for (const double rock : {5e7, 2e8, 2e9})
    for (const int rods : {1, 6, 20}) {
      double before = 0;
      for (const double contact : {1.0, 0.8, 0.6, 0.4, 0.2, 0.0}) {
        CAPTURE(rock);
        CAPTURE(rods);
        CAPTURE(contact);
        const double energy = ringing_energy(plain_string(3.66, 0.038, rods), drilling(rods, rock, contact));
        CHECK(energy > before);
        before = energy;
      }
    }
}

TEST_CASE("a moving rod leaves nothing above its modes, nor does a change of rods") {
  StringModel model = plain_string();
  model.bending_low_s = model.bending_high_s = 30;
  CHECK(gliding_residue_db(model, 0.75, 0.5, 0.056) <= -90);
  StringLayer layer(model, kStringRate, 1, 0);
  const auto sound = struck(layer, {1, 0.00101, 100}, [](double t) {
    StringInput input = drilling(t < 0.5 ? 1 : 6, 2e8, 0);
    input.exposed_m = t < 0.5 ? 0.5 : 3.66;
    return input;
  });
  CHECK(residue_above_modes_db(sound, 0.45, 0.6) <= -90);
}

TEST_CASE("rods, rock and feed are heard: no two alike, and further apart than two seeds") {
  const StringModel model;
  const auto one = rendered(model, drilling(), 1, 4);
  const double floor = third_octave_distance_db(one, rendered(model, drilling(), 2, 4));
  const auto six = rendered(model, drilling(6), 1, 4), twenty = rendered(model, drilling(20), 1, 4);
  const auto soft = rendered(model, drilling(1, 3e7), 1, 4), hard = rendered(model, drilling(1, 3e9), 1, 4);
  const auto underfed = rendered(model, drilling(1, 2e8, 0.3), 1, 4);
  CHECK(third_octave_distance_db(one, six) >= 2 * floor);
  CHECK(third_octave_distance_db(six, twenty) >= 2 * floor);
  CHECK(third_octave_distance_db(soft, hard) >= 2 * floor);
  CHECK(third_octave_distance_db(one, underfed) >= 2 * floor);
}

TEST_CASE("after a change of rods the new string rings as if there had never been another") {
  const StringModel model = plain_string();
  StringLayer changed(model, kStringRate, 1, 0), born(plain_string(3.66, 0.038, 6), kStringRate, 1, 0);
  // The first blow still rings when the rods change; the second comes after both fades.
  const StringBlows blows{1, 0.05, 0.25, 0.31};
  const auto sound = struck(changed, blows, [](double t) { return drilling(t < 0.06 ? 1 : 6, 2e8, 0.5); });
  const auto alone = struck(born, {1, 0.30, 100}, [](double) { return drilling(6, 2e8, 0.5); });
  CHECK(after(sound, 0.29, kStringRate) == after(alone, 0.29, kStringRate));
}

TEST_CASE("rods may change again and again, each time to the string as it should be") {
  StringLayer changed(plain_string(), kStringRate, 1, 0), born(plain_string(), kStringRate, 1, 0);
  const auto sound = struck(changed, {1, 0.05, 0.25, 0.56},
                            [](double t) { return drilling(t < 0.06 || t > 0.31 ? 1 : 6, 2e8, 0.5); });
  const auto alone = struck(born, {1, 0.55, 100}, [](double) { return drilling(1, 2e8, 0.5); });
  CHECK(after(sound, 0.54, kStringRate) == after(alone, 0.54, kStringRate));
}

TEST_CASE("a new string fades in over 20 ms along a smooth step") {
  StringLayer changed(plain_string(), kStringRate, 1, 0),
      born(plain_string(3.66, 0.038, 6), kStringRate, 1, 0);
  const StringInput one = drilling(1, 2e8, 0.5), six = drilling(6, 2e8, 0.5);
  const Impact blow{5.25, 1, 0};
  double x[kChunk], y[kChunk], worst = 0, loudest = 0;
  for (int chunk = 0; chunk < 60; ++chunk) {
    changed.process(one, {&blow, chunk == 50 ? 1 : 0}, x);
    born.process(six, {}, y);
  }
  // What rings fades out first.
  do changed.process(six, {}, x), born.process(six, {}, y);
  while (std::any_of(x, x + kChunk, [](double sample) { return sample != 0; }));
  for (int chunk = 1; chunk < 50; ++chunk) {
    changed.process(six, {&blow, chunk == 1 ? 1 : 0}, x);
    born.process(six, {&blow, chunk == 1 ? 1 : 0}, y);
    for (int n = 0; n < kChunk; ++n) {
      const double share = std::min(1.0, (chunk * kChunk + n) / (0.020 * kStringRate));
      worst = std::max(worst, std::fabs(x[n] - share * share * (3 - 2 * share) * y[n]));
      loudest = std::max(loudest, std::fabs(y[n]));
    }
  }
  CHECK(loudest > 0);
  CHECK(worst < 1e-9 * loudest);
}

TEST_CASE("a breaking rod snaps once, louder than any blow, and both parts ring on in the air") {
  const StringModel model = plain_string();
  const auto broken = [](double from_s) {
    return [=](double t) {
      StringInput input = drilling(6);
      input.broken = t >= from_s;
      return input;
    };
  };
  StringLayer whole(model, kStringRate, 1, 0), breaks(model, kStringRate, 1, 0);
  const auto before = struck(whole, {2}, broken(100)), sound = struck(breaks, {2}, broken(1));
  const auto peak = [](const std::vector<double>& x, double from_s, double to_s) {
    double most = 0;
    for (auto n = static_cast<std::size_t>(from_s * kStringRate);
         n < static_cast<std::size_t>(to_s * kStringRate); ++n)
      most = std::max(most, std::fabs(x[n]));
    return most;
  };
  CHECK(std::equal(sound.begin(), sound.begin() + 47000, before.begin()));
  CHECK(peak(sound, 1, 1.02) > 2 * peak(before, 0, 2));
  CHECK(peak(sound, 1.3, 2) < peak(sound, 1, 1.02));
  CHECK(energy_within(sound, 1.5, 2) > 4 * energy_within(before, 1.5, 2));
}

TEST_CASE("the snap is a Hann pulse of 60 us, as much louder than a mean blow as the model says") {
  StringModel model = bare_string(3.66, 2);
  model.bending_mix = 0, model.highpass_hz = 10;
  const double peak = model.level * std::pow(10, model.snap_db / 20);
  for (const double rate : {44100.0, 48000.0, 96000.0}) {
    StringLayer layer(model, rate, 1, 0);
    StringInput input = drilling(2);
    double out[kChunk];
    for (int chunk = 0; chunk < 20; ++chunk) layer.process(input, {}, out);
    input.broken = true;
    layer.process(input, {}, out);
    CAPTURE(rate);
    for (int n = 0; n < kChunk; ++n) {  // it comes back later
      const double t = (n + 0.5) / (60e-6 * rate);
      const double snap = t < 1 ? peak / 2 * (1 - std::cos(2 * M_PI * t)) : 0;
      CHECK(std::fabs(-out[n] - snap) < 0.01 * peak);
    }
  }
}

TEST_CASE("a mended string is a new one") {
  const StringModel model = plain_string();
  StringLayer mended(model, kStringRate, 1, 0), born(model, kStringRate, 1, 0);
  const auto sound = struck(mended, {1, 0.05, 0.25, 0.31}, [](double t) {
    StringInput input = drilling(1, 2e8, 0.5);
    input.broken = t > 0.03 && t < 0.2;
    return input;
  });
  const auto alone = struck(born, {1, 0.30, 100}, [](double) { return drilling(1, 2e8, 0.5); });
  CHECK(after(sound, 0.29, kStringRate) == after(alone, 0.29, kStringRate));
}

TEST_CASE("a string left alone falls silent with exact zeros") {
  StringModel model = plain_string();
  model.string_low_s = model.string_high_s = 0.3;
  model.bending_low_s = model.bending_high_s = 0.3;
  StringLayer layer(model, kStringRate, 1, 0);
  const auto sound = struck(layer, {4, 0.01, 100}, [](double) { return drilling(); });
  CHECK(energy_within(sound, 0, 0.5) > 0);
  CHECK(energy_within(sound, 3.5, 4) == 0);
  double out[kChunk];
  CHECK_FALSE(layer.process(drilling(), {}, out));  // and says so
  const Impact blow{5, 1, 0};
  CHECK(layer.process(drilling(), {&blow, 1}, out));
}

TEST_CASE(
    "the layer repeats itself bit for bit at both lane widths, differs between booms, never allocates") {
  const StringModel model;
  const auto controls = [](double t) {
    StringInput input = drilling(t < 0.3 ? 1 : 20, t < 0.1 ? 2e8 : 1e9, 0.5 + 0.5 * std::cos(20 * t));
    input.exposed_m = 3.66 - t;
    input.broken = t > 0.6 && t < 0.8;
    return input;
  };
  for (const double length : {0.6, 3.66}) {
    StringModel other = model;
    other.rod_length_m = length;
    StringLayer first(other, kStringRate, 9, 0), again(other, kStringRate, 9, 0),
        boom(other, kStringRate, 9, 1);
    StringLayer narrow(other, kStringRate, 9, 0, dsp::LaneWidth::kTwo);
    const auto sound = struck(first, {1}, controls);
    CHECK(struck(again, {1}, controls) == sound);
    CHECK(struck(narrow, {1}, controls) == sound);
    CHECK(struck(boom, {1}, controls) != sound);
    double out[kChunk];
    const long before = allocations();
    for (int chunk = 0; chunk < 1500; ++chunk) {
      const Impact blow{1.5, 1, static_cast<std::uint64_t>(chunk)};
      first.process(controls(chunk * kChunk / kStringRate), {&blow, chunk % 40 == 0}, out);
    }
    CHECK(allocations() == before);
  }
}

TEST_CASE("what makes no sense is refused by its key") {
  const auto complaint = [](const std::function<void(StringModel&)>& spoil) {
    StringModel model;
    spoil(model);
    try {
      StringLayer(model, kStringRate, 1, 0);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what()).substr(0, std::string(error.what()).find(':'));
    }
    return std::string("accepted");
  };
  CHECK(complaint([](StringModel&) {}) == "accepted");
  CHECK(complaint([](StringModel& m) { m.rod_length_m = 6.5; }) == "rod_length_m");
  CHECK(complaint([](StringModel& m) { m.rod_diameter_m = 0.02; }) == "rod_diameter_m");
  CHECK(complaint([](StringModel& m) { m.rod_length_m = 0.6, m.rod_diameter_m = 0.07; }) == "rod_diameter_m");
  CHECK(complaint([](StringModel& m) { m.rods = 21; }) == "rods");
  CHECK(complaint([](StringModel& m) { m.shank_length_m = 0.3; }) == "shank_length_m");
  CHECK(complaint([](StringModel& m) { m.sleeve_impedance = 0.9; }) == "sleeve_impedance");
  CHECK(complaint([](StringModel& m) { m.sleeve_length_m = std::nan(""); }) == "sleeve_length_m");
  CHECK(complaint([](StringModel& m) { m.string_high_s = 2; }) == "string_high_s");
  CHECK(complaint([](StringModel& m) { m.guided_s = 0; }) == "guided_s");
  CHECK(complaint([](StringModel& m) { m.contact_low_s = 5; }) == "contact_low_s");
  CHECK(complaint([](StringModel& m) { m.strike_width_s = 0.01; }) == "strike_width_s");
  CHECK(complaint([](StringModel& m) { m.bounces = 5; }) == "bounces");
  CHECK(complaint([](StringModel& m) { m.highpass_hz = 5; }) == "highpass_hz");
  CHECK(complaint([](StringModel& m) { m.level = -1; }) == "level");
}
