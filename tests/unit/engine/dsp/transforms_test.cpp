// FFT and MDCT against the sums that define them.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "rigsound/dsp/fft.hpp"
#include "rigsound/dsp/mdct.hpp"
#include "rigsound/dsp/random.hpp"

using namespace rigsound;

namespace {

template <class T>
std::vector<T> noise(int count, std::uint64_t stream) {
  const dsp::RandomField random(11, stream);
  std::vector<T> x;
  for (int n = 0; n < count; ++n)
    x.push_back(static_cast<T>(2 * random.uniform(static_cast<std::uint64_t>(n), 0) - 1));
  return x;
}

template <class T>
void check_fft(int size, double tolerance) {
  CAPTURE(size);
  const std::vector<T> re = noise<T>(size, 1), im = noise<T>(size, 2);
  std::vector<T> r = re, i = im;
  const dsp::Fft<T> fft(size);
  CHECK(fft.size() == size);
  fft.forward(r.data(), i.data());
  for (std::size_t k = 0; k < re.size(); ++k) {
    std::complex<double> sum = 0;
    for (std::size_t n = 0; n < re.size(); ++n)
      sum += std::complex<double>(static_cast<double>(re[n]), static_cast<double>(im[n])) *
             std::polar(1.0, -2 * M_PI * static_cast<double>(n * k) / size);
    REQUIRE(std::abs(std::complex<double>(static_cast<double>(r[k]), static_cast<double>(i[k])) - sum) <
            tolerance * size);
  }
  fft.inverse(r.data(), i.data());
  for (std::size_t n = 0; n < re.size(); ++n) {
    REQUIRE(std::fabs(static_cast<double>(r[n]) / size - static_cast<double>(re[n])) < tolerance);
    REQUIRE(std::fabs(static_cast<double>(i[n]) / size - static_cast<double>(im[n])) < tolerance);
  }
}

double sine_window(int k, int M) { return std::sin(M_PI / (2 * M) * (k + 0.5)); }
double basis(int k, int q, int M) {
  return std::sqrt(2.0 / M) * sine_window(k, M) * std::cos(M_PI / M * (k + 0.5 + M / 2.0) * (q + 0.5));
}

template <class T>
void check_mdct(int M, double tolerance) {
  CAPTURE(M);
  dsp::Mdct<T> bank(M);
  CHECK(bank.channels() == M);
  const std::vector<T> x = noise<T>(4 * M, 3);
  std::vector<T> X(static_cast<std::size_t>(M)), y(X.size()), overlap(X.size(), T(0));
  for (int hop = 0; hop < 3; ++hop) {
    bank.analyse(x.data() + hop * M, X.data());
    for (int q = 0; q < M; ++q) {
      double sum = 0;
      for (int k = 0; k < 2 * M; ++k)
        sum += static_cast<double>(x[static_cast<std::size_t>(hop * M + k)]) * basis(k, q, M);
      REQUIRE(std::fabs(static_cast<double>(X[static_cast<std::size_t>(q)]) - sum) < tolerance);
    }
    bank.synthesise(X.data(), overlap.data(), y.data());
    for (int k = 0; hop > 0 && k < M; ++k)  // the first hop lacks its own first half
      REQUIRE(std::fabs(static_cast<double>(y[static_cast<std::size_t>(k)]) -
                        static_cast<double>(x[static_cast<std::size_t>(hop * M + k)])) < tolerance);
  }
  // What is left over is the second half of the last frame.
  for (int k = 0; k < M; ++k) {
    double sum = 0;
    for (int q = 0; q < M; ++q)
      sum += static_cast<double>(X[static_cast<std::size_t>(q)]) * basis(M + k, q, M);
    REQUIRE(std::fabs(static_cast<double>(overlap[static_cast<std::size_t>(k)]) - sum) < tolerance);
  }
}

}  // namespace

TEST_CASE("the FFT is the discrete Fourier transform, its inverse gives the signal back") {
  for (const int size : {1, 2, 4, 8, 64}) {
    check_fft<double>(size, 1e-14);
    check_fft<float>(size, 1e-6);
  }
}

TEST_CASE("the MDCT is its sum for fast and slow sizes, and overlapping hops give the signal back") {
  for (const int M : {1, 2, 3, 4, 6, 8, 12, 16, 31, 64}) {
    check_mdct<double>(M, 1e-13);
    check_mdct<float>(M, 3e-6);
  }
}

TEST_CASE("a transform that is used twice gives the same twice") {
  for (const int M : {6, 8}) {
    dsp::Mdct<double> bank(M);
    const std::vector<double> x = noise<double>(2 * M, 4);
    std::vector<double> first(static_cast<std::size_t>(M)), second(first.size());
    bank.analyse(x.data(), first.data());
    bank.analyse(x.data(), second.data());
    CHECK(first == second);
  }
}
