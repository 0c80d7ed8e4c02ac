// The transform alone: does it invert, and does it find a 1/f law again?
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "background/table.hpp"
#include "diesel/hbwt.hpp"
#include "note/subband_noise.hpp"
#include "rigsound/dsp/fft.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::bench {
namespace {

using namespace rigsound::analysis;

template <class T>
double reconstruction_error(const HbwtShape& shape) {
  SplitMix draw(1);
  const std::vector<double> x = draw.normals(static_cast<std::size_t>(shape.P * 77 + 13));
  const std::vector<T> input(x.begin(), x.end());
  const std::vector<T> y = inverse_hbwt(hbwt(input, shape));
  double error = 0, power = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    error += std::pow(static_cast<double>(y[i]) - static_cast<double>(input[i]), 2);
    power += x[i] * x[i];
  }
  return std::sqrt(error / power);
}

void reconstruction_rows(Table& table) {
  const HbwtShape even[] = {{8, 1, 5},     {640, 1, 5},   {1024, 1, 5}, {1024, 4, 5}, {1024, 16, 5},
                            {1024, 64, 5}, {4096, 16, 5}, {960, 15, 5}, {256, 256, 5}};
  const HbwtShape odd[] = {{101, 1, 5}, {367, 1, 5}, {999, 9, 5}};
  double worst_even = 0, worst_odd = 0, worst_float = 0;
  for (const HbwtShape& shape : even) {
    worst_even = std::max(worst_even, reconstruction_error<double>(shape));
    worst_float = std::max(worst_float, reconstruction_error<float>(shape));
  }
  for (const HbwtShape& shape : odd) {
    worst_odd = std::max(worst_odd, reconstruction_error<double>(shape));
    worst_float = std::max(worst_float, reconstruction_error<float>(shape));
  }
  table.at_most("perfect reconstruction, double, even M", 1e-14, worst_even, "");
  table.at_most("perfect reconstruction, double, odd M", 2e-13, worst_odd, "");
  table.at_most("perfect reconstruction, float", -125, 20 * std::log10(worst_float), "dB");
}

/// Power 1/f^gamma up to half the rate; the middle of a circle twice as long, so its ends do not meet.
std::vector<double> one_over_f(SplitMix& draw, std::size_t length, double gamma) {
  const std::size_t size = 2 * length;
  std::vector<double> re = draw.normals(size), im(size, 0.0);
  const dsp::Fft<double> fft(static_cast<int>(size));
  fft.forward(re.data(), im.data());
  re[0] = im[0] = 0;
  for (std::size_t b = 1; b < size; ++b) {
    const double gain = std::pow(static_cast<double>(std::min(b, size - b)), -gamma / 2);
    re[b] *= gain, im[b] *= gain;
  }
  fft.inverse(re.data(), im.data());
  const auto middle = re.begin() + static_cast<std::ptrdiff_t>(length / 2);
  return {middle, middle + static_cast<std::ptrdiff_t>(length)};
}

struct Spread {
  double mean = 0, deviation = 0;
};

/// Every channel of a pseudo-periodic noise follows the same law; what the transform of the sound finds.
Spread recovered_gamma(double gamma) {
  constexpr int P = 64, N = 6;
  constexpr std::size_t kPeriods = 4096;
  SplitMix draw(2);
  std::vector<double> X(P * kPeriods);
  for (std::size_t q = 0; q < P; ++q) {
    const std::vector<double> line = one_over_f(draw, kPeriods, gamma);
    for (std::size_t r = 0; r < kPeriods; ++r) X[r * P + q] = line[r];
  }
  const HbwtCoefficients<double> c = hbwt(from_mdct_frames(X, P), {P, 1, N});
  Spread spread;
  double squares = 0;
  for (std::size_t q = 0; q < P; ++q) {
    std::vector<double> variance;
    for (const std::vector<double>& rows : c.d) {
      Subband channel;
      const std::size_t count = rows.size() / P;
      for (std::size_t i = 1; i + 8 < count; ++i) channel.push_back(rows[i * P + q]);  // the ends wrap
      variance.push_back(power_of(channel));
    }
    const double found = fit_one_over_f(variance).gamma;
    spread.mean += found / P, squares += found * found / P;
  }
  spread.deviation = std::sqrt(squares - spread.mean * spread.mean);
  return spread;
}

}  // namespace

void transform_rows(Table& table) {
  reconstruction_rows(table);
  double worst_mean = 0, worst_deviation = 0;
  for (const double gamma : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const Spread spread = recovered_gamma(gamma);
    worst_mean = std::max(worst_mean, std::fabs(spread.mean - gamma));
    worst_deviation = std::max(worst_deviation, spread.deviation);
  }
  table.at_most("1/f recovery, gamma 0...2: mean error", 0.03, worst_mean, "");
  table.at_most("1/f recovery, gamma 0...2: standard deviation", 0.10, worst_deviation, "");
}

}  // namespace rigsound::bench
