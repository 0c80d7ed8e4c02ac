#include "clicks/whitening.hpp"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "analysis/noise.hpp"
#include "rigsound/dsp/linear_prediction.hpp"

using namespace rigsound::analysis;

TEST_CASE("Levinson's filter solves the normal equations") {
  TestNoise noise(31);
  const Eigen::ArrayXd x = noise.normals(400);
  const int order = 12;
  Eigen::ArrayXd r(order + 1);
  for (int k = 0; k <= order; ++k) r(k) = (x.head(400 - k) * x.tail(400 - k)).sum();
  Eigen::MatrixXd R(order, order);
  for (int i = 0; i < order; ++i)
    for (int j = 0; j < order; ++j) R(i, j) = r(std::abs(i - j));
  const Eigen::VectorXd solved = R.ldlt().solve(-r.tail(order).matrix());
  const std::vector<double> filter = rigsound::dsp::levinson({r.begin(), r.end()}).a;
  const Eigen::Map<const Eigen::ArrayXd> a(filter.data(), order + 1);
  CHECK(a(0) == 1);
  CHECK((a.tail(order).matrix() - solved).norm() < 1e-10);
}

TEST_CASE("the whitener of an autoregressive noise is the filter that made it") {
  TestNoise noise(32);
  Eigen::ArrayXd x = noise.normals(60000);
  for (long n = 2; n < x.size(); ++n) x(n) += 1.6 * x(n - 1) - 0.8 * x(n - 2);
  const Eigen::ArrayXd a = lpc_whitener(samples(x), 6);
  CHECK(a(1) == doctest::Approx(-1.6).epsilon(0.02));
  CHECK(a(2) == doctest::Approx(0.8).epsilon(0.02));
  CHECK(a.tail(4).abs().maxCoeff() < 0.03);
}

TEST_CASE("whitening is the convolution with the filter, at RMS 1") {
  TestNoise noise(33);
  const Eigen::ArrayXd x = noise.normals(5000), A = noise.normals(9);
  const Eigen::ArrayXd y = whiten(samples(x), A);
  Eigen::ArrayXd expected = Eigen::ArrayXd::Zero(5000);
  for (long k = 0; k < 9; ++k) expected.tail(5000 - k) += A(k) * x.head(5000 - k);
  expected /= std::sqrt(expected.square().mean());
  CHECK((y - expected).abs().maxCoeff() < 1e-4);
}

TEST_CASE("the noise-aware whitener turns loud backgrounds down by (N + 0.1 S)(S + N)/S") {
  Eigen::ArrayXd S(257), N(257);
  for (int f = 0; f < 257; ++f) {
    S(f) = 1 + 0.5 * std::cos(0.03 * f);
    N(f) = 0.2 + 2 * std::exp(-std::pow((f - 90) / 25.0, 2));
  }
  const Eigen::ArrayXd A = noise_aware_whitener(S, N);
  CHECK(A.size() == 193);
  const auto response = [&](int f) {
    double re = 0, im = 0;
    for (int k = 0; k < A.size(); ++k)
      re += A(k) * std::cos(kPi * f * k / 256), im -= A(k) * std::sin(kPi * f * k / 256);
    return re * re + im * im;
  };
  const Eigen::ArrayXd D = (N + 0.1 * S) * (S + N) / S;
  for (const int f : {20, 60, 90, 120, 200})
    CHECK(response(f) / response(220) == doctest::Approx(D(220) / D(f)).epsilon(0.1));
}
