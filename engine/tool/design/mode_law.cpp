#include "tool/design/mode_law.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

using dsp::kPi;

constexpr double kExactUpTo = 20000;  // Hz; nothing above is a target

/// Hutchinson's shear coefficient of a round bar.
constexpr double kShear = 6 * (1 + kPoisson) * (1 + kPoisson) / (7 + 12 * kPoisson + 4 * kPoisson * kPoisson);
constexpr double kE = 2 * (1 + kPoisson) / kShear;  // E / (k' G)
constexpr double kC2 = kSpeedOfSound * kSpeedOfSound;

double tanh(double x) { return 1 - 2 / (dsp::exp(2 * x) + 1); }

/// Root k of cos(beta) cosh(beta) = 1, the free-free Euler-Bernoulli bar.
double euler_bernoulli_root(int k) {
  double beta = (k + 0.5) * kPi;
  for (int i = 0; i < 12; ++i) {
    const double e = dsp::exp(-beta), sech = 2 * e / (1 + e * e);
    beta -= (dsp::cos(beta) - sech) / (sech * tanh(beta) - dsp::sin(beta));
  }
  return beta;
}

/// Lower branch of the Timoshenko dispersion relation: rad/s at wave number gamma (rad/m).
double timoshenko(double gamma, double diameter) {
  const double r2 = diameter * diameter / 16, g2 = gamma * gamma;
  const double A = kE * r2 / (kC2 * kC2), B = (1 + g2 * r2 * (1 + kE)) / kC2, C = g2 * g2 * r2;
  return std::sqrt(2 * C / (B + std::sqrt(B * B - 4 * A * C)));
}

/// Bending moment and shear force that one of the two waves exerts on the bar's end.
struct EndLoad {
  double moment, shear;
};

/// The wave with squared wave number g2; below zero it is evanescent, and both loads are divided by the
/// hyperbolic cosine, which would overflow.
EndLoad end_load(double g2, double W2, double half, bool symmetric) {
  if (g2 > 0) {
    const double g = std::sqrt(g2), B = (kE * W2 - g2) / g;
    const double c = dsp::cos(g * half), s = dsp::sin(g * half);
    return symmetric ? EndLoad{B * g * c, (-g - B) * s} : EndLoad{B * g * s, (g + B) * c};
  }
  const double q = std::sqrt(-g2), B = (q * q + kE * W2) / q, t = tanh(q * half);
  return symmetric ? EndLoad{B * q, (q - B) * t} : EndLoad{B * q * t, q - B};
}

/// Zero where a free-free bar has a mode at `omega`.
double characteristic(double omega, const Bar& bar, bool symmetric) {
  const double r2 = bar.diameter_m * bar.diameter_m / 16, W2 = omega * omega / kC2;
  const double b = W2 * (1 + kE), c = kE * W2 * W2 - W2 / r2, root = std::sqrt(b * b - 4 * c);
  const EndLoad p = end_load((b + root) / 2, W2, bar.length_m / 2, symmetric);
  const EndLoad q = end_load((b - root) / 2, W2, bar.length_m / 2, symmetric);
  return p.moment * q.shear - p.shear * q.moment;
}

/// Secant from the closed form, which is at most 9 cents away.
double exact_mode(double guess, const Bar& bar, bool symmetric) {
  double x0 = guess * (1 - 1e-4), x1 = guess * (1 + 1e-4);
  double y0 = characteristic(x0, bar, symmetric), y1 = characteristic(x1, bar, symmetric);
  for (int i = 0; i < 30 && std::fabs(x1 - x0) > 1e-12 * x1 && y1 != y0; ++i) {
    const double x2 = x1 - y1 * (x1 - x0) / (y1 - y0);
    x0 = x1, y0 = y1;
    x1 = x2, y1 = characteristic(x1, bar, symmetric);
  }
  return x1;
}

}  // namespace

int ModeLaw::count_below(double hz) const {
  int k = 0;
  while (at(k + 1) < hz) ++k;
  return k;
}

double ModeLaw::density(double kappa) const {
  constexpr double kStep = 1e-3;
  return 2 * kStep / (at(kappa + kStep) - at(kappa - kStep));
}

TransversalLaw::TransversalLaw(const Bar& bar) : bar_(bar) {
  double omega = 0;
  for (int k = 1; omega < dsp::kTwoPi * kExactUpTo; ++k) {
    const double guess = timoshenko(euler_bernoulli_root(k) / bar.length_m, bar.diameter_m);
    omega = exact_mode(guess, bar, k % 2 == 1);
    correction_.push_back(dsp::log(omega / timoshenko((k + 0.5) * kPi / bar.length_m, bar.diameter_m)));
  }
}

double TransversalLaw::correction(double kappa) const {
  const std::size_t n = correction_.size();
  if (kappa <= 1) return correction_.front();
  if (kappa >= static_cast<double>(n)) return correction_.back();
  const auto i = static_cast<std::size_t>(kappa);
  const double t = kappa - static_cast<double>(i);
  return correction_[i - 1] * (1 - t) + correction_[i] * t;
}

double TransversalLaw::at(double kappa) const {
  const double gamma = (kappa + 0.5) * kPi / bar_.length_m;
  return timoshenko(gamma, bar_.diameter_m) / dsp::kTwoPi * dsp::exp(correction(kappa));
}

double LongitudinalLaw::at(double kappa) const {
  const double q = kPoisson * kappa * kPi * bar_.diameter_m / (2 * bar_.length_m);
  return kappa * kSpeedOfSound / (2 * bar_.length_m) / std::sqrt(1 + q * q / 2);
}

}  // namespace rigsound::tool

namespace rigsound {

std::vector<double> modes_below(const Bar& bar, double highest_hz) {
  std::vector<double> modes;
  const tool::TransversalLaw bending(bar);
  const tool::LongitudinalLaw stretching(bar);
  for (int k = 1; bending.at(k) < highest_hz; ++k) modes.push_back(bending.at(k));
  for (int k = 1; stretching.at(k) < highest_hz; ++k) modes.push_back(stretching.at(k));
  std::sort(modes.begin(), modes.end());
  return modes;
}

}  // namespace rigsound
