// Where the modes of the drill string lie: as listed, and in the sound.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <string>

#include "engine/heard.hpp"
#include "engine/string/string_sounds.hpp"
#include "string/bending_modes.hpp"
#include "string/design/mode_table.hpp"
#include "string/design/string_tuning.hpp"
#include "tool/design/mode_law.hpp"

using namespace rigsound;
using namespace rigsound::tests;

namespace {

std::vector<StringMode> family(const StringModel& model, double exposed_m, std::string_view name) {
  std::vector<StringMode> found;
  for (const StringMode& mode : string_modes(model, exposed_m, kStringRate))
    if (mode.family == name) found.push_back(mode);
  return found;
}

/// Reactance that the string shows at the bit: zero, rising, at every mode of a free string.
double reactance(const StringModel& m, double hz) {
  double X = 0;
  const auto through = [&](double Z, double length) {
    const double t = std::tan(2 * M_PI * hz * length / 5200);
    X = Z * (X + Z * t) / (Z - X * t);
  };
  const auto joint = [&] { through(m.sleeve_impedance, m.sleeve_length_m); };
  const bool shank = m.shank_length_m > 0;
  if (shank) through(1, m.shank_length_m - m.sleeve_length_m / 2), joint();
  for (int rod = 1; rod <= m.rods; ++rod) {
    const int sleeves = (shank || rod > 1 ? 1 : 0) + (rod < m.rods ? 1 : 0);  // half of each is over the rod
    through(1, m.rod_length_m - m.sleeve_length_m * 0.5 * sleeves);
    if (rod < m.rods) joint();
  }
  return X;
}

}  // namespace

TEST_CASE("a free string without joints is a comb of m c / 2 N L, within two cents") {
  for (const double L : {0.6, 0.88, 1.83, 3.66, 6.1, 6.4})
    for (const int N : {1, 6, 20}) {
      const auto modes = family(bare_string(L, N), L, "longitudinal");
      const int count = static_cast<int>(6000 / (5200 / (2 * N * L)));
      REQUIRE(modes.size() == static_cast<std::size_t>(count));
      for (const StringMode& mode : modes) {
        CAPTURE(L);
        CAPTURE(N);
        CHECK(std::fabs(cents(mode.target_hz, mode.mode * 5200 / (2 * N * L))) < 1e-6);
        CHECK(std::fabs(cents(mode.model_hz, mode.mode * 5200 / (2 * N * L))) < 2);
      }
    }
}

TEST_CASE("joints are where one-dimensional scattering has its modes") {
  for (const double impedance : {1.2, 2.5})
    for (const auto& [N, shank_m] : {std::pair{1, 0.5}, {6, 0.5}, {2, 0.0}, {6, 0.0}}) {
      StringModel model = plain_string(1.83, 0.038, N);
      model.sleeve_impedance = impedance;
      model.shank_length_m = shank_m;
      CAPTURE(model.rods);
      CAPTURE(model.shank_length_m);
      const auto modes = family(model, 1.83, "longitudinal");
      REQUIRE(modes.size() >= 5);
      for (const StringMode& mode : modes) {
        CAPTURE(mode.target_hz);
        CHECK(reactance(model, mode.target_hz * (1 - 1e-7)) < 0);
        CHECK(reactance(model, mode.target_hz * (1 + 1e-7)) > 0);
      }
    }
}

TEST_CASE("what the list says the layer plays is in the sound of its waves") {
  for (const int N : {1, 6})
    for (const bool bare : {true, false}) {
      StringModel model = bare ? bare_string(3.66, N) : plain_string(3.66, 0.038, N);
      model.string_low_s = model.string_high_s = 30;
      const auto sound = free_ringing(model, 0.5);
      for (const StringMode& mode : family(model, 3.66, "longitudinal")) {
        if (mode.mode % N != 1 % N && !bare) continue;  // others stand too close to be told apart
        CAPTURE(mode.mode);
        CHECK(std::fabs(cents(frequency_near(sound, mode.model_hz, kStringRate), mode.model_hz)) < 0.2);
      }
    }
}

TEST_CASE("the decays that the list tells of a string's waves, free and pressed, are those of its sound") {
  for (const auto& rods : {std::pair{3.66, 1}, {1.0, 3}, {1.22, 2}}) {
    const double L = rods.first;
    StringModel model = bare_string(L, rods.second);
    model.sleeve_impedance = 1.0001;  // fractions of a sample to every rod, but waves pass
    model.string_low_s = 0.5, model.string_high_s = 0.3;
    constexpr std::size_t kWindow = 4800, kApart = 4800;
    const auto amplitude = [](const std::vector<double>& sound, double hz, std::size_t from) {
      std::complex<double> sum;
      for (std::size_t n = 0; n < kWindow; ++n)
        sum += sound[from + n] * (1 - std::cos(2 * M_PI * static_cast<double>(n) / kWindow)) *
               std::polar(1.0, -2 * M_PI * hz / kStringRate * static_cast<double>(n));
      return std::abs(sum);
    };
    const auto measured_s = [&](const std::vector<double>& sound, double hz) {
      const double nepers = std::log(amplitude(sound, hz, 480) / amplitude(sound, hz, 480 + kApart));
      return 3 * std::log(10) * kApart / kStringRate / nepers;
    };
    const auto free = free_ringing(model, 0.3), pressed = free_ringing(model, 0.3, dsp::widest_lanes(), 1);
    for (const StringMode& mode : family(model, L, "longitudinal")) {
      CAPTURE(L);
      CAPTURE(mode.mode);
      CHECK(mode.t60_s == doctest::Approx(measured_s(free, mode.model_hz)).scale(0).epsilon(0.01));
      CHECK(mode.t60_pressed_s == doctest::Approx(measured_s(pressed, mode.model_hz)).scale(0).epsilon(0.01));
      CHECK(1 / mode.t60_pressed_s == doctest::Approx(1 / mode.t60_s + 1 / model.guided_s).epsilon(1e-9));
    }
  }
}

TEST_CASE("bending modes are the exact free-free Timoshenko modes of what is exposed, within two cents") {
  for (const auto& [L, d] : {std::pair{3.66, 0.038}, {6.4, 0.025}, {6.1, 0.051}, {1.83, 0.032}, {6.4, 0.076}})
    for (const double share : {1.0, 0.5, 0.25}) {
      const auto exact = timoshenko_modes(L * share, d, 12000);
      const auto modes = family(plain_string(L, d), L * share, "bending");
      REQUIRE(modes.size() == exact.size());
      for (std::size_t k = 0; k < exact.size(); ++k) {
        const double exposed_m = L * share;
        CAPTURE(exposed_m);
        CAPTURE(k + 1);
        CHECK(std::fabs(cents(modes[k].target_hz, exact[k])) < 0.001);
        if (exact[k] > 60) CHECK(std::fabs(cents(modes[k].model_hz, exact[k])) < 2);
      }
    }
}

TEST_CASE("the table of bending modes is within 0.06 cents at every length, and held within its ends") {
  for (const auto& [L, d] : {std::pair{3.66, 0.038}, {6.4, 0.025}, {0.6, 0.032}}) {
    const StringModel model = plain_string(L, d);
    const string::ModeTable table(model, kStringRate);
    const double shortest = string::kShortest * d;
    for (double length = shortest; length < L; length *= 1.013) {
      const tool::TransversalLaw law(Bar{length, d});
      const string::TableCut cut = table.cut(length);
      CHECK(cut.weight[0] + cut.weight[1] + cut.weight[2] + cut.weight[3] == doctest::Approx(1));
      for (int k = 0; k < string::kMaxModes && law.at(k + 1) < string::kFadeTo_hz; ++k) {
        CAPTURE(length);
        CAPTURE(k);
        const double hz = std::atan(cut.at(k)) * kStringRate / M_PI;
        CHECK(std::fabs(cents(hz, law.at(k + 1))) < 0.06);
      }
    }
    CHECK(table.cut(10 * L).at(0) == table.cut(100 * L).at(0));
    CHECK(table.cut(10 * L).row[0] == table.cut(L).row[0]);  // no row beyond the last is read
    CHECK(table.cut(10 * L).at(0) < table.cut(L).at(0) * (1 + 1e-9));
    CHECK(table.cut(10 * L).at(0) > table.cut(L).at(0) * 0.9);  // a row further at most
    CHECK(table.cut(0.1 * shortest).at(0) == table.cut(0.01 * shortest).at(0));
    CHECK(table.cut(0.1 * shortest).at(0) == doctest::Approx(table.cut(shortest).at(0)));
  }
}

TEST_CASE("the first bending mode of a 38 mm rod is at 19, 13, 10 and 5 Hz") {
  const std::vector<std::pair<double, int>> rods = {{3.05, 19}, {3.66, 13}, {4.27, 10}, {6.10, 5}};
  for (const auto& [L, hz] : rods)
    CHECK(std::lround(family(plain_string(L), L, "bending").front().target_hz) == hz);
}

TEST_CASE("bending modes and their decays are in the sound of the bank") {
  StringModel model = plain_string();
  model.bending_low_s = 3, model.bending_high_s = 1;
  string::BendingModes bank(model, kStringRate, dsp::widest_lanes());
  const double exposed_m = 1.1;
  bank.set(exposed_m, 0);
  bank.retune();
  double blow[kChunk] = {1}, none[kChunk] = {}, out[kChunk];
  std::vector<double> sound;
  for (int i = 0; i < 600; ++i) {
    bank.process(i == 0 ? blow : none, i == 0, out);
    sound.insert(sound.end(), out, out + kChunk);
  }
  for (const StringMode& mode : family(model, exposed_m, "bending")) {
    if (mode.target_hz < 60 || mode.target_hz > 9900) continue;
    CAPTURE(mode.mode);
    CHECK(std::fabs(cents(frequency_near(sound, mode.target_hz, kStringRate), mode.target_hz)) < 0.5);
    CHECK(mode.t60_s <= 3.05);
    CHECK(mode.t60_s >= 0.6);
  }
}

TEST_CASE("the bit's loading time and the energy it sends back follow their formulas") {
  const StringModel model = plain_string();
  const double Z = M_PI / 4 * 0.038 * 0.038 * 7850 * 5200;
  CHECK(loading_time_s(model, 2e8) == doctest::Approx(Z / 2e8).epsilon(1e-12));
  CHECK(reflected_energy(1.256) == doctest::Approx(0.1855).epsilon(1e-3));
  CHECK(reflected_energy(1e-6) == doctest::Approx(1).epsilon(1e-4));
  CHECK(reflected_energy(1e6) == doctest::Approx(1).epsilon(1e-4));
  CHECK(reflected_energy(1.2) > reflected_energy(1.256));
  CHECK(reflected_energy(1.3) > reflected_energy(1.256));
}

TEST_CASE("a round trip loses at 500 and 5000 Hz what the model's decay times there say") {
  for (const int rods : {1})  // the filter of a longer string cannot fall that far
    for (const double rate : {44100.0, 96000.0}) {
      StringModel model = plain_string(3.66, 0.038, rods);
      model.string_low_s = 0.5, model.string_high_s = 0.3;
      const string::StringTuning tuning = string::tune_string(model, rods, rate);
      const auto gain = [&](double hz) {
        return tuning.loss_middle + 2 * tuning.loss_side * std::cos(2 * M_PI * hz / rate);
      };
      const auto wanted = [&](double t60_s) {
        return std::pow(10, -3 * tuning.round_trip() / (t60_s * rate));
      };
      CAPTURE(rods);
      CHECK(gain(500) == doctest::Approx(wanted(0.5)).epsilon(1e-9));
      CHECK(gain(5000) == doctest::Approx(wanted(0.3)).epsilon(1e-9));
      CHECK(gain(0) <= 1);
      CHECK(gain(rate / 2) >= -1e-12);
    }
}
