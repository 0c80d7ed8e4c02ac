#include "simulate/biquad_cascade.hpp"

#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {

Biquad peaking(double f, double gain_db, double q) {
  const double A = std::pow(10, gain_db / 40), w = dsp::kTwoPi * f / kAnalysisRate;
  const double alpha = std::sin(w) / (2 * q), c = std::cos(w), a0 = 1 + alpha / A;
  return {(1 + alpha * A) / a0, -2 * c / a0, (1 - alpha * A) / a0, -2 * c / a0, (1 - alpha / A) / a0};
}

Biquad highpass(double f, double q) {
  const double w = dsp::kTwoPi * f / kAnalysisRate;
  const double alpha = std::sin(w) / (2 * q), c = std::cos(w), a0 = 1 + alpha;
  return {(1 + c) / 2 / a0, -(1 + c) / a0, (1 + c) / 2 / a0, -2 * c / a0, (1 - alpha) / a0};
}

Biquad high_shelf(double f, double gain_db) {
  constexpr double kQ = 0.5;
  const double A = std::pow(10, gain_db / 40), w = dsp::kTwoPi * f / kAnalysisRate;
  const double c = std::cos(w), root = 2 * std::sqrt(A) * std::sin(w) / (2 * kQ);
  const double a0 = (A + 1) - (A - 1) * c + root;
  return {A * ((A + 1) + (A - 1) * c + root) / a0, -2 * A * ((A - 1) + (A + 1) * c) / a0,
          A * ((A + 1) + (A - 1) * c - root) / a0, 2 * ((A - 1) - (A + 1) * c) / a0,
          ((A + 1) - (A - 1) * c - root) / a0};
}

Biquad one_pole(double f) {
  const double p = std::exp(-dsp::kTwoPi * f / kAnalysisRate);
  return {1 - p, 0, 0, -p, 0};
}

void filter(const BiquadCascade& sections, std::vector<double>& x) {
  for (const Biquad& s : sections) {
    double z1 = 0, z2 = 0;
    for (double& v : x) {
      const double y = s.b0 * v + z1;
      z1 = s.b1 * v - s.a1 * y + z2;
      z2 = s.b2 * v - s.a2 * y;
      v = y;
    }
  }
}

}  // namespace rigsound::analysis
