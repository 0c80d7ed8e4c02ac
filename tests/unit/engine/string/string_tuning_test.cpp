// The string on the sample grid: nothing is lost but fractions of a sample, and those are where they may be.
#include "string/design/string_tuning.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "rigsound/machine/limits.hpp"

using namespace rigsound;
using namespace rigsound::string;

namespace {

struct Case {
  StringModel model;
  int rods;
  double rate;

  StringTuning tuning() const { return tune_string(model, rods, rate); }
  int joints() const { return model.shank_length_m > 0 ? rods : rods - 1; }
  double samples(double length_m) const { return 2 * length_m / 5200 * rate; }
  double sleeve() const { return samples(model.sleeve_length_m); }

  /// Round trip over line j as the sleeves around it leave it, those on the grid being `held` long.
  double line(int j, const StringTuning& t) const {
    const double held = kSleeveStep * t.sleeve_steps;
    const double more = model.sleeve_impedance * sleeve() - t.sleeve_impedance * held - sleeve();
    const bool shank = j == 0 && model.shank_length_m > 0;
    const int sides = (j > 0 ? 1 : 0) + (j < joints() ? 1 : 0);
    return samples(shank ? model.shank_length_m : model.rod_length_m) + 0.5 * sides * more;
  }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double rate : {44100.0, 48000.0, 96000.0, 192000.0})
    for (const double shank_m : {0.0, 0.4, 0.7})
      for (const double rod_m : {0.6, 1.83, 3.66, 6.4})
        for (const double impedance : {1.0, 1.6, 2.5})
          for (const double sleeve_m : {0.15, 0.2, 0.25})
            for (const int rods : {1, 2, 6, 7, 20}) {
              Case c{{}, rods, rate};
              c.model.shank_length_m = shank_m, c.model.rod_length_m = rod_m;
              c.model.sleeve_impedance = impedance, c.model.sleeve_length_m = sleeve_m;
              all.push_back(c);
            }
  return all;
}

constexpr double kMatters_hz = 4500;  // where a fraction of a sample is held

double delay_of(const double* tap, double omega) {
  const std::complex<double> z = std::polar(1.0, -omega);
  return -std::arg(tap[0] + tap[1] * z + tap[2] * z * z) / omega;
}

double delay_of(const Thiran& s, double omega) {
  const std::complex<double> z = std::polar(1.0, -omega);
  return -std::arg((s.a2 + s.a1 * z + z * z) / (1.0 + s.a1 * z + s.a2 * z * z)) / omega;
}

}  // namespace

TEST_CASE("on the grid a string keeps its mass and its compliance") {
  for (const Case& c : cases()) {
    const StringTuning t = c.tuning();
    const double held = kSleeveStep * t.sleeve_steps, Z = c.model.sleeve_impedance;
    const double plain =
        c.samples(c.model.shank_length_m + c.rods * c.model.rod_length_m) - t.joints * c.sleeve();
    const double rods = t.round_trip() - t.joints * held;
    CAPTURE(c.rods);
    CAPTURE(c.rate);
    CAPTURE(c.model.rod_length_m);
    REQUIRE(t.joints == c.joints());
    // A fraction held at 4.5 kHz is a little longer at 0 Hz.
    const double slack = t.has_fractions ? 0.03 * t.joints : 1e-9;
    CHECK(std::fabs(rods + t.joints * t.sleeve_impedance * held - plain - t.joints * Z * c.sleeve()) <=
          slack);
    CHECK(std::fabs(rods + t.joints / t.sleeve_impedance * held - plain - t.joints / Z * c.sleeve()) <=
          slack);
    CHECK(t.sleeve_impedance >= 1);
    CHECK(t.reflection() == doctest::Approx((t.sleeve_impedance - 1) / (t.sleeve_impedance + 1)));
  }
}

TEST_CASE("a sleeve is the nearest of 4, 8 and 16 samples long") {
  for (const Case& c : cases())
    for (const int steps : {1, 2, 4})
      CHECK(std::fabs(kSleeveStep * c.tuning().sleeve_steps - c.sleeve()) <=
            std::fabs(kSleeveStep * steps - c.sleeve()));
}

TEST_CASE("few rods or short ones end on a fraction of a sample, others within half a sample of the way") {
  for (const Case& c : cases()) {
    const StringTuning t = c.tuning();
    const bool sleeves = c.model.sleeve_impedance > 1;
    CHECK(t.has_fractions == (sleeves && (c.rods <= 6 || c.model.rod_length_m < 2.5)));
    const int least = kSleeveStep * t.sleeve_steps;
    // A short shank takes whole samples from the rods, from the first of them on.
    const bool lends = c.line(0, t) < least + 3;
    double wanted = 0, placed = 0;
    for (int j = t.joints; j > 0; --j) {
      const double omega = 2 * M_PI * kMatters_hz / c.rate;
      const double beyond = t.has_fractions ? delay_of(lagrange(t.fraction[j]).tap, omega) : 0;
      CHECK(t.delay[j] >= least);
      wanted += c.line(j, t), placed += t.delay[j] + beyond;
      CAPTURE(j);
      if (lends || c.line(j, t) < least + 1) continue;
      CHECK(std::fabs(placed - wanted) <= (t.has_fractions ? 1e-6 : 0.5 + 1e-9));
    }
  }
}

TEST_CASE("the rest is in the allpass at the shank, whose delay is 1.5 to 2.5 samples") {
  int lent = 0;
  for (const Case& c : cases()) {
    const StringTuning t = c.tuning();
    const double head = 1 + t.delay[0] + t.head_delay, least = kSleeveStep * t.sleeve_steps;
    CHECK(t.head_delay >= 1.5 - 1e-9);
    CHECK(t.head_delay <= 2.5 + 1e-9);
    CHECK(head >= least + 2.5 - 1e-9);
    const double wanted = c.line(0, t);
    if (wanted >= least + 3) CHECK(std::fabs(head - wanted) <= 0.5 + 1e-9);
    if (wanted < least + 1.9) {
      ++lent;
      CHECK(head < least + 3.5);  // no more than it needs
    }
    if (t.has_fractions && wanted >= least + 2.5) CHECK(head == doctest::Approx(wanted));
  }
  CHECK(lent > 0);
}

TEST_CASE("line by line a chunk is computed, two sleeves or one, as much as every line's round trip holds") {
  bool seen[3] = {};
  for (const Case& c : cases()) {
    const StringTuning t = c.tuning();
    const int first = t.joints == 0 ? 0 : 1, sleeve = kSleeveStep * t.sleeve_steps;
    const int shortest = *std::min_element(t.delay + first, t.delay + t.joints + 1);
    const int expected = shortest >= kChunk ? kChunk : shortest >= 2 * sleeve ? 2 * sleeve : sleeve;
    CHECK(t.block == expected);
    seen[expected == kChunk ? 0 : expected == sleeve ? 2 : 1] = true;
  }
  CHECK(seen[0]);
  CHECK(seen[1]);
}

TEST_CASE("the reflection at the shank holds 500 Hz, and 5 kHz where no gain turns negative or exceeds 1") {
  int held = 0, bounded = 0;
  for (Case c : cases()) {
    c.model.string_low_s = 0.5, c.model.string_high_s = 0.2;
    const StringTuning t = c.tuning();
    const auto gain = [&](double hz) {
      return t.loss_middle + 2 * t.loss_side * std::cos(2 * M_PI * hz / c.rate);
    };
    const auto wanted = [&](double t60_s) { return std::pow(10, -3 * t.round_trip() / (t60_s * c.rate)); };
    CHECK(gain(500) == doctest::Approx(wanted(0.5)).epsilon(1e-9));
    CHECK(gain(0) <= 1 + 1e-12);
    CHECK(gain(c.rate / 2) >= -1e-12);
    const bool meets = std::fabs(gain(5000) - wanted(0.2)) < 1e-9;
    const bool at_end = 1 - gain(0) < 1e-9 || gain(c.rate / 2) < 1e-9;
    CHECK((meets || at_end));
    CHECK(gain(5000) >= wanted(0.2) - 1e-9);
    held += meets ? 1 : 0, bounded += meets ? 0 : 1;
  }
  CHECK(held > 0);
  CHECK(bounded > 0);
}

TEST_CASE("interpolator and allpass delay by what they are told, and neither makes anything louder") {
  constexpr double kSlow = 1e-3;  // rad/sample
  for (double d = -0.5; d <= 0.5; d += 0.1) {
    const Lagrange s = lagrange(d);
    CHECK(delay_of(s.tap, kSlow) == doctest::Approx(1 + d).epsilon(1e-6));
    for (double omega = 0; omega < 3.1; omega += 0.3) {
      const std::complex<double> z = std::polar(1.0, -omega);
      const double power = std::norm(s.tap[0] + s.tap[1] * z + s.tap[2] * z * z);
      CHECK(power == doctest::Approx(1 - d * d * (1 - d * d) * std::pow(1 - std::cos(omega), 2)));
    }
  }
  for (double delay = 1.5; delay <= 2.5; delay += 0.1) {
    const Thiran s = thiran(delay);
    CHECK(delay_of(s, kSlow) == doctest::Approx(delay).epsilon(1e-9));
    CHECK(delay_of(s, 0.1) == doctest::Approx(delay).epsilon(1e-6));  // flat
  }
}
