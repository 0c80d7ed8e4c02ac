#include "spectrum/frame_pair.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <cmath>

#include "analysis/noise.hpp"

using namespace rigsound::analysis;

namespace {

constexpr int kSize = 64;

std::complex<double> direct_bin(const Eigen::ArrayXd& x, int k) {
  std::complex<double> sum = 0;
  for (int n = 0; n < kSize; ++n) sum += x(n) * std::polar(1.0, -2 * kPi * k * n / kSize);
  return sum;
}

}  // namespace

TEST_CASE("two real frames in one transform keep their spectra, and come back") {
  TestNoise noise(3);
  const Eigen::ArrayXd a = noise.normals(kSize), b = noise.normals(kSize);
  FramePair pair(kSize), back(kSize);
  for (int n = 0; n < kSize; ++n) pair.first()[n] = float(a(n)), pair.second()[n] = float(b(n));
  pair.forward();
  for (int k = 0; k <= kSize / 2; ++k) {
    const std::complex<double> A = direct_bin(a, k), B = direct_bin(b, k);
    CHECK(std::abs(std::complex<double>(pair.first_bin(k)) - A) < 1e-5);
    CHECK(std::abs(std::complex<double>(pair.second_bin(k)) - B) < 1e-5);
    CHECK(pair.power(k) == doctest::Approx(std::norm(A) + std::norm(B)).epsilon(1e-5));
    back.set_bins(k, pair.first_bin(k), pair.second_bin(k));
  }
  back.inverse();
  for (int n = 0; n < kSize; ++n) {
    CHECK(std::fabs(back.first()[n] - a(n)) < 1e-5);
    CHECK(std::fabs(back.second()[n] - b(n)) < 1e-5);
  }
}
