#include "denoise/beyond_chance.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "analysis/noise.hpp"
#include "denoise/cs_nmf.hpp"
#include "denoise/initial_nmf.hpp"
#include "spectrum/stft.hpp"

using namespace rigsound::analysis;

namespace {

/// 25 bursts a second of noise below 1 kHz or so, in white noise that is `hiss` as loud.
std::vector<float> low_bursts(double hiss) {
  TestNoise noise(7);
  std::vector<float> x(96000);
  double low = 0, lower = 0;
  for (size_t n = 0; n < x.size(); ++n) {
    low += 0.1 * (noise.normal() - low);
    lower += 0.1 * (low - lower);
    x[n] = float(lower * std::exp(-0.002 * double(n % 1920)) + hiss * noise.normal());
  }
  return x;
}

double sum_between(const Eigen::ArrayXd& psd, double from_hz, double to_hz) {
  const long first = std::lround(from_hz / 93.75), last = std::lround(to_hz / 93.75);
  return psd.segment(first, last - first).sum();
}

}  // namespace

TEST_CASE("beyond chance a blind split takes no hiss for drilling, and all of what it hears below") {
  const PowerSpectrogram power = power_spectrogram(stft(low_bursts(0.02), kChainStft));
  const WordFit clip(power);
  const Factors blind = initial_nmf(clip, {});
  const MeanPsd as_it_is = mean_psd(blind, power),
                beyond = psd_beyond_chance(blind, power, itakura_saito(power, background_nmf(clip)));
  CHECK(sum_between(as_it_is.S, 6000, 24000) > 0.08 * sum_between(as_it_is.N, 6000, 24000));
  CHECK(sum_between(beyond.S, 6000, 24000) < 0.02 * sum_between(beyond.N, 6000, 24000));
  CHECK(sum_between(beyond.S, 100, 600) > 0.8 * sum_between(as_it_is.S, 100, 600));
  CHECK((beyond.S + beyond.N).isApprox(as_it_is.S + as_it_is.N, 1e-9));
}
