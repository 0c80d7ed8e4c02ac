// The transform against its definition: it inverts, keeps energy, and puts a harmonic where it should.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "diesel/hbwt.hpp"
#include "rigsound/dsp/mdct.hpp"
#include "rigsound/dsp/wavelet.hpp"

using namespace rigsound;
using namespace rigsound::analysis;

namespace {

std::vector<double> white(std::size_t n, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& v : x) v = normal(generator);
  return x;
}

template <class T>
double relative_error(const std::vector<double>& x, const HbwtShape& shape) {
  const std::vector<T> input(x.begin(), x.end());
  const std::vector<T> y = inverse_hbwt(hbwt(input, shape));
  REQUIRE(y.size() == x.size());
  double error = 0, power = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    error += std::pow(static_cast<double>(y[i]) - static_cast<double>(input[i]), 2);
    power += x[i] * x[i];
  }
  return std::sqrt(error / power);
}

}  // namespace

TEST_CASE("db4 is orthonormal and has four vanishing moments") {
  for (int shift = 0; shift < 4; ++shift) {
    double sum = 0;
    for (int k = 0; k + 2 * shift < dsp::kDb4Taps; ++k)
      sum += dsp::kDb4Scaling[k] * dsp::kDb4Scaling[k + 2 * shift];
    CHECK(std::abs(sum - (shift == 0)) < 3e-16);
  }
  for (int moment = 0; moment < 4; ++moment) {
    double sum = 0;
    for (int k = 0; k < dsp::kDb4Taps; ++k) sum += std::pow(k, moment) * dsp::db4_wavelet(k);
    CHECK(std::abs(sum) < 1e-12);
  }
}

TEST_CASE("MDCT equals its formula, fast and direct") {
  for (int M : {4, 6, 16, 64}) {
    dsp::Mdct<double> bank(M);
    const std::vector<double> x = white(static_cast<std::size_t>(2 * M), 3);
    std::vector<double> X(static_cast<std::size_t>(M));
    bank.analyse(x.data(), X.data());
    for (int q = 0; q < M; ++q) {
      double sum = 0;
      for (int k = 0; k < 2 * M; ++k)
        sum += std::sin(M_PI / (2 * M) * (k + 0.5)) * x[static_cast<std::size_t>(k)] *
               std::cos(M_PI / M * (k + 0.5 + M / 2.0) * (q + 0.5));
      CHECK(X[static_cast<std::size_t>(q)] == doctest::Approx(std::sqrt(2.0 / M) * sum).epsilon(1e-11));
    }
  }
}

TEST_CASE("perfect reconstruction: any period, any slots, even and odd") {
  struct Case {
    int P, L;
  };
  for (const Case c : {Case{8, 1}, {640, 1}, {1024, 1}, {1024, 16}, {1024, 64}, {960, 15}, {256, 256}}) {
    const std::vector<double> x = white(static_cast<std::size_t>(c.P * 37 + 13), 1);
    CAPTURE(c.P);
    CAPTURE(c.L);
    CHECK(relative_error<double>(x, {c.P, c.L, 5}) <= 1e-14);
    CHECK(20 * std::log10(relative_error<float>(x, {c.P, c.L, 5})) <= -125);
  }
  for (const Case c : {Case{101, 1}, {367, 1}, {999, 9}}) {
    const std::vector<double> x = white(static_cast<std::size_t>(c.P * 37 + 13), 2);
    CAPTURE(c.P);
    CHECK(relative_error<double>(x, {c.P, c.L, 5}) <= 2e-13);
  }
}

TEST_CASE("a harmonic lies in its two channels, constant in time") {
  constexpr int P = 64, kHarmonic = 5, kFrames = 8;
  std::vector<double> x(P * kFrames);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::cos(2 * M_PI * kHarmonic * static_cast<double>(i) / P + 0.7);
  const std::vector<double> X = mdct_frames(x, P);
  double inside = 0, outside = 0, change = 0;
  for (int r = 1; r < kFrames; ++r)
    for (int q = 0; q < P; ++q) {
      const double v = X[static_cast<std::size_t>(r * P + q)];
      const bool own = q == 2 * kHarmonic - 1 || q == 2 * kHarmonic;
      (own ? inside : outside) += v * v;
      if (own) change = std::max(change, std::abs(v - X[static_cast<std::size_t>(P + q)]));
    }
  CHECK(outside / inside <= 1e-12);
  CHECK(change < 1e-12);
}
