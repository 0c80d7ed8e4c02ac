#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "rigsound/dsp/all_pole.hpp"
#include "rigsound/dsp/butterworth.hpp"
#include "rigsound/dsp/linear_prediction.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;

namespace {

constexpr int kSamples = 4096;

std::vector<float> noise(std::uint64_t stream) {
  const dsp::RandomField random(3, stream);
  std::vector<float> x(kSamples);
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = static_cast<float>(random.white(n, 0));
  return x;
}

/// The prediction of a body's noise: it falls by 12 dB an octave and has three resonances 20 dB high.
std::vector<double> prediction(int order) {
  constexpr int kBins = 2048;
  std::vector<double> r(static_cast<std::size_t>(order + 1), 0.0);
  for (int bin = 0; bin < kBins; ++bin) {
    const double f = (bin + 0.5) / kBins;
    double power = 1e-4 / (1e-4 + f * f * f * f);
    for (const double peak : {0.01, 0.04, 0.15})
      power *= 1 + 99 / (1 + std::pow((f - peak) / (0.05 * peak), 2));
    for (std::size_t lag = 0; lag < r.size(); ++lag)
      r[lag] += power * std::cos(3.141592653589793 * f * static_cast<double>(lag));
  }
  return dsp::levinson(r).a;
}

/// y[n] = x[n] - sum a[k] y[n - k], as it is written.
std::vector<double> recursion(const std::vector<double>& a, const std::vector<float>& x) {
  std::vector<double> y(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) {
    y[n] = static_cast<double>(x[n]);
    for (std::size_t k = 1; k < a.size() && k <= n; ++k) y[n] -= a[k] * y[n - k];
  }
  return y;
}

}  // namespace

TEST_CASE("1/A is its recursion, whatever its order, to 90 dB") {
  for (const int order : {0, 1, 2, 3, 7, 8, 9, 16, 48, 96, 97}) {
    CAPTURE(order);
    const std::vector<double> a = prediction(order);
    std::vector<float> y = noise(1);
    const std::vector<double> wanted = recursion(a, y);
    dsp::AllPole filter(a);
    filter.process(y.data(), kSamples / 2);
    filter.process(y.data() + kSamples / 2, kSamples / 2);
    double error = 0, energy = 0;
    for (std::size_t n = 0; n < y.size(); ++n) {
      error += std::pow(static_cast<double>(y[n]) - wanted[n], 2);
      energy += wanted[n] * wanted[n];
    }
    CHECK(error < 1e-9 * energy);
    filter.reset();
    std::vector<float> again = noise(1);
    filter.process(again.data(), kSamples);
    CHECK(again == y);
  }
}

TEST_CASE("a crossover joins what the low-pass and the high-pass at its frequency make") {
  const std::vector<float> low = noise(2), high = noise(3);
  dsp::Butterworth6 under(dsp::Pass::kLow, 700, 48000), over(dsp::Pass::kHigh, 700, 48000);
  dsp::Crossover6 crossover(700, 48000);
  std::vector<double> y(kSamples, 0.25), wanted(kSamples);
  for (std::size_t n = 0; n < wanted.size(); ++n)
    wanted[n] =
        0.25 + (under.process(static_cast<double>(low[n])) + over.process(static_cast<double>(high[n])));
  crossover.add(low.data(), high.data(), y.data(), 100);
  crossover.add(low.data() + 100, high.data() + 100, y.data() + 100, kSamples - 100);
  CHECK(y == wanted);
  crossover.reset();
  std::vector<double> silent(64, 0.0);
  const std::vector<float> nothing(64, 0.0F);
  crossover.add(nothing.data(), nothing.data(), silent.data(), 64);
  CHECK(silent == std::vector<double>(64, 0.0));
}
