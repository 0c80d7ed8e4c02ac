#include "spectrum/stft.hpp"

#include <doctest/doctest.h>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

TEST_CASE("the transform gives back what went in, for both shapes and odd lengths") {
  TestNoise noise(1);
  for (const StftShape& shape : {kChainStft, kPaperStft})
    for (const long length : {5000L, 12345L}) {
      const std::vector<float> x = samples(noise.normals(length));
      const std::vector<float> y = inverse_stft(stft(x, shape), x.size(), shape);
      double error = 0;
      for (size_t n = 0; n < x.size(); ++n) error = std::max(error, std::fabs(double(x[n]) - y[n]));
      CHECK(error < 1e-5);
    }
}

TEST_CASE("a cosine on a bin has half the window's sum there") {
  std::vector<float> x(8192);
  const int bin = 20;
  for (size_t n = 0; n < x.size(); ++n) x[n] = float(std::cos(2 * kPi * bin * double(n) / kChainStft.fft));
  const Spectrogram X = stft(x, kChainStft);
  CHECK(std::abs(X(bin, 30)) == doctest::Approx(kChainStft.window / 4.0).epsilon(1e-4));
  CHECK(std::abs(X(bin + 2, 30)) < 1e-2);
}

TEST_CASE("a frame is centred on its multiple of the hop") {
  std::vector<float> x(8192, 0.0f);
  x[40 * 128] = 1;
  const Spectrogram X = stft(x, kChainStft);
  CHECK(std::abs(X(7, 40)) == doctest::Approx(1.0));
  CHECK(std::abs(X(7, 39)) == doctest::Approx(std::abs(X(7, 41))));
  CHECK(std::abs(X(7, 42)) < 1e-6);
}

TEST_CASE("the mean power is that of the transform, for odd and even numbers of frames") {
  TestNoise noise(2);
  for (const long frames : {40L, 41L}) {
    const std::vector<float> x = samples(noise.normals(frames * kChainStft.hop));
    const Eigen::ArrayXd mean = stft(x, kChainStft).abs2().cast<double>().rowwise().mean();
    CHECK((mean_power(x, kChainStft) / mean - 1).abs().maxCoeff() < 1e-4);
  }
}
