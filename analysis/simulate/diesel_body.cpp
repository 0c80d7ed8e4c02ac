#include "simulate/diesel_body.hpp"

#include <cmath>
#include <complex>

#include "rigsound/analysis/rate.hpp"
#include "simulate/biquad_cascade.hpp"

namespace rigsound::analysis {
namespace {

struct Resonance {
  double f_hz, Q, gain;
};

constexpr double kDirect = 0.06;
constexpr double kDcPole = 0.995;  // microphones have no response at DC
constexpr Resonance kResonances[] = {{62, 6, 1.0},     {118, 7, 0.9},    {185, 8, 0.9},    {310, 9, 0.6},
                                     {455, 10, 0.55},  {690, 12, 0.45},  {980, 12, 0.5},   {1430, 14, 0.4},
                                     {2050, 16, 0.45}, {2900, 16, 0.35}, {4300, 14, 0.25}, {6100, 12, 0.15}};

/// Band pass of unit gain at its centre.
Biquad band(const Resonance& r) {
  const double w = 2 * M_PI * r.f_hz / kAnalysisRate, alpha = std::sin(w) / (2 * r.Q), a0 = 1 + alpha;
  return {alpha / a0, 0, -alpha / a0, -2 * std::cos(w) / a0, (1 - alpha) / a0};
}

}  // namespace

std::vector<double> through_body(const std::vector<double>& x) {
  std::vector<double> sum(x.size());
  for (std::size_t n = 0; n < x.size(); ++n) sum[n] = kDirect * x[n];
  for (const Resonance& r : kResonances) {
    std::vector<double> part = x;
    filter({band(r)}, part);
    for (std::size_t n = 0; n < x.size(); ++n) sum[n] += r.gain * part[n];
  }
  filter({{1, -1, 0, -kDcPole, 0}}, sum);
  return sum;
}

double simulated_body_db(double f_hz) {
  const std::complex<double> z = std::polar(1.0, -2 * M_PI * f_hz / kAnalysisRate);
  std::complex<double> H = kDirect;
  for (const Resonance& r : kResonances) {
    const Biquad b = band(r);
    H += r.gain * (b.b0 + b.b2 * z * z) / (1.0 + b.a1 * z + b.a2 * z * z);
  }
  return 20 * std::log10(std::abs(H * (1.0 - z) / (1.0 - kDcPole * z)));
}

}  // namespace rigsound::analysis
