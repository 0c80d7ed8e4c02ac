// Sine oscillators: frequency, level, ramp, linewidth, and silence before they would fold over.
#include "diesel/tone_bank.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "engine/heard.hpp"
#include "rigsound/machine/limits.hpp"

using namespace rigsound;
using namespace rigsound::diesel;
using namespace rigsound::tests;

namespace {

std::vector<double> played(const DieselOscillator& tone, double f, int chunks, dsp::Ramp gain = {1, 1}) {
  ToneBank bank({tone}, kRate, 3, 44);
  std::vector<double> x(static_cast<std::size_t>(chunks * kChunk), 0.0);
  for (int c = 0; c < chunks; ++c) bank.add(f, gain, x.data() + c * kChunk);
  return x;
}

/// Amplitude at `hz`.
double line(const std::vector<double>& x, double hz) {
  double re = 0, im = 0;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double angle = 2 * M_PI * hz / kRate * static_cast<double>(n);
    re += x[n] * std::cos(angle), im += x[n] * std::sin(angle);
  }
  return 2 * std::hypot(re, im) / static_cast<double>(x.size());
}

}  // namespace

TEST_CASE("a tone sounds at its frequency or its order of the speed, with its amplitude, without a seam") {
  CHECK(line(played({750, false, 0.25, 0}, 10, 640), 750) == doctest::Approx(0.25).epsilon(2e-6));
  const std::vector<double> locked = played({75, true, 0.25, 0}, 10, 640);
  CHECK(line(locked, 750) == doctest::Approx(0.25).epsilon(2e-6));
  for (std::size_t n = 1; n + 1 < locked.size(); ++n)  // a sine satisfies its difference equation everywhere
    REQUIRE(locked[n + 1] + locked[n - 1] ==
            doctest::Approx(2 * std::cos(2 * M_PI * 750 / kRate) * locked[n]).scale(1).epsilon(1e-6));
}

TEST_CASE("a chunk's gain goes in a straight line to its target") {
  const std::vector<double> full = played({5000, false, 0.5, 0}, 10, 1),
                            ramped = played({5000, false, 0.5, 0}, 10, 1, {0.2, 0.8});
  for (std::size_t n = 0; n < full.size(); ++n)
    CHECK(ramped[n] == doctest::Approx(full[n] * (0.2 + 0.6 * (static_cast<double>(n) + 1) / kChunk))
                           .scale(1)
                           .epsilon(2e-7));
}

TEST_CASE("a tone is silent from 0.46 of the sampling rate on") {
  const auto peak = [](double hz) {
    double most = 0;
    for (const double x : played({hz, false, 0.5, 0}, 10, 40)) most = std::max(most, std::fabs(x));
    return most;
  };
  CHECK(peak(0.459 * kRate) > 0.4);
  CHECK(peak(0.461 * kRate) == 0);
}

TEST_CASE("the phase walks by 2 pi linewidth rad^2 a second") {
  constexpr double kLinewidth_hz = 2;
  constexpr int kChunks = 40000;
  const std::vector<double> x = played({750, false, 1, kLinewidth_hz}, 10, kChunks);
  double sum = 0, before = 0;
  for (int c = 0; c < kChunks; ++c) {
    double re = 0, im = 0;
    for (int n = 0; n < kChunk; ++n) {
      const double angle = 2 * M_PI * 750 / kRate * n;
      re += x[static_cast<std::size_t>(c * kChunk + n)] * std::cos(angle);
      im -= x[static_cast<std::size_t>(c * kChunk + n)] * std::sin(angle);
    }
    // Over one chunk of half a period cosine and sine are orthogonal.
    const double phase = std::atan2(im, re);
    if (c > 0) sum += std::pow(std::remainder(phase - before - 2 * M_PI * 750 / kRate * kChunk, 2 * M_PI), 2);
    before = phase;
  }
  const double per_second = sum / kChunks * kRate / kChunk;
  CHECK(per_second == doctest::Approx(2 * M_PI * kLinewidth_hz).epsilon(0.03));
}

TEST_CASE("tones of one bank are another's neighbours, not its copies") {
  ToneBank bank({{750, false, 1, 0}, {750, false, 1, 0}}, kRate, 3, 44);
  double x[kChunk] = {};
  bank.add(10, {1, 1}, x);
  double most = 0;
  for (const double v : x) most = std::max(most, std::fabs(v));
  CHECK(most < 1.999);  // two phases
}
