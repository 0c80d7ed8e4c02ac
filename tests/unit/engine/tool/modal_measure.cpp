#include "engine/tool/modal_measure.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <complex>

namespace rigsound::tests {
namespace {

using Polynomial = std::vector<double>;  // ascending powers of z^-1
using Scalar = std::complex<double>;

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

/// Roots in z of c0 + c1 z^-1 + ... + cn z^-n: eigenvalues of the companion matrix.
std::vector<Scalar> roots(const Polynomial& c) {
  const auto n = static_cast<Eigen::Index>(c.size()) - 1;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) companion(0, i) = -c[static_cast<std::size_t>(i) + 1] / c[0];
  companion.diagonal(-1).setOnes();
  const Eigen::VectorXcd z = companion.eigenvalues();
  return {z.begin(), z.end()};
}

/// A rational function of z kept in factors, since expanding it would cost its low modes their digits.
struct Factored {
  std::vector<std::pair<Polynomial, Polynomial>> parts;
  double gain = 1;
  int delay = 0;
};

Scalar value(const Polynomial& c, Scalar z) {
  Scalar sum = 0;
  for (std::size_t i = c.size(); i-- > 0;) sum = sum / z + c[i];
  return sum;
}

/// d/dz of the above.
Scalar slope(const Polynomial& c, Scalar z) {
  Scalar sum = 0;
  for (std::size_t i = 1; i < c.size(); ++i)
    sum -= static_cast<double>(i) * c[i] * std::pow(z, -static_cast<double>(i) - 1);
  return sum;
}

Scalar value(const Factored& f, Scalar z) {
  Scalar product = f.gain * std::pow(z, -f.delay);
  for (const auto& [top, bottom] : f.parts) product *= value(top, z) / value(bottom, z);
  return product;
}

Scalar slope(const Factored& f, Scalar z) {
  Scalar log_slope = -static_cast<double>(f.delay) / z;
  for (const auto& [top, bottom] : f.parts)
    log_slope += slope(top, z) / value(top, z) - slope(bottom, z) / value(bottom, z);
  return value(f, z) * log_slope;
}

/// Bilinear a0 + a1 p + a2 p^2 over (1 + z^-1)^2, p = (1 - z^-1) / (1 + z^-1).
Polynomial quadratic(double a0, double a1, double a2) {
  return {a0 + a1 + a2, 2 * a0 - 2 * a2, a0 - a1 + a2};
}

Polynomial linear(double a0, double a1) { return {a0 + a1, a0 - a1}; }

}  // namespace

std::vector<MeasuredMode> measure_modes(const std::vector<double>& all, int order, int every) {
  std::vector<double> sound;
  for (std::size_t n = 0; n < all.size(); n += static_cast<std::size_t>(every)) sound.push_back(all[n]);
  const auto rows = static_cast<Eigen::Index>(sound.size()) - order;
  Eigen::MatrixXd past(rows, order);
  Eigen::VectorXd now(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    now(i) = sound[static_cast<std::size_t>(i + order)];
    for (int j = 0; j < order; ++j) past(i, j) = sound[static_cast<std::size_t>(i + order - 1 - j)];
  }
  const Eigen::VectorXd prediction = past.colPivHouseholderQr().solve(now);
  Polynomial c{1.0};
  for (int j = 0; j < order; ++j) c.push_back(-prediction(j));
  std::vector<MeasuredMode> modes;
  for (const Scalar z : roots(c))
    if (z.imag() > 0) modes.push_back({std::arg(z) / every, std::log(std::abs(z)) / every});
  return modes;
}

MeasuredMode nearest(const std::vector<MeasuredMode>& modes, double omega) {
  MeasuredMode best;
  for (const MeasuredMode& mode : modes)
    if (std::fabs(mode.omega - omega) < std::fabs(best.omega - omega)) best = mode;
  return best;
}

std::vector<double> modal_bank(const LoopDesign& loop, double k, int samples) {
  Factored round{{}, k, loop.delay_samples};
  const auto part = [&](const Polynomial& top, const Polynomial& bottom) {
    round.parts.push_back({top, bottom});
  };
  part(linear(0, 1), linear(loop.filters.dc, 1));
  part(linear(loop.filters.shelf, loop.filters.shelf_gain), linear(loop.filters.shelf, 1));
  for (int i = 0; i < loop.allpass.sections; ++i) {
    const auto [b, c] = loop.allpass.section[static_cast<std::size_t>(i)];
    part(quadratic(c, -b, 1), quadratic(c, b, 1));
  }
  for (int i = 0; i < loop.allpass.first_orders; ++i)
    part(linear(loop.allpass.a, -1), linear(loop.allpass.a, 1));

  Polynomial top{k}, closed{1.0};
  for (const auto& [numerator, denominator] : round.parts)
    top = times(top, numerator), closed = times(closed, denominator);
  closed.resize(top.size() + static_cast<std::size_t>(loop.delay_samples), 0.0);
  for (std::size_t i = 0; i < top.size(); ++i)
    closed[i + static_cast<std::size_t>(loop.delay_samples)] -= top[i];

  // y/x = 1 / (1 - round); a simple pole z adds residue z^n with residue = -1 / (z round'(z)).
  std::vector<double> y(static_cast<std::size_t>(samples), 0.0);
  for (Scalar z : roots(closed)) {
    for (int i = 0; i < 8; ++i) z += (1.0 - value(round, z)) / slope(round, z);
    Scalar term = -1.0 / (z * slope(round, z));
    for (double& sample : y) sample += term.real(), term *= z;
  }
  return y;
}

}  // namespace rigsound::tests
