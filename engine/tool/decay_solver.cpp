#include "tool/decay_solver.hpp"

#include <cmath>
#include <stdexcept>

#include "tool/loop_response.hpp"

namespace rigsound::tool {
namespace {

/// One wanted decay as a condition on k and q = (k g)^2: k^2 a^2 + q |p|^2 + 2 a k sqrt(q) Re p = R.
struct Condition {
  dsp::Complex p;
  double R = 0;

  Condition(const LoopDesign& loop, double hz, double t60_s, double sample_rate) {
    const double sigma = -3 * dsp::kLn10 / (t60_s * sample_rate);
    const LoopFilters& f = loop.filters;
    p = bilinear({sigma, dsp::kTwoPi * hz / sample_rate});
    const dsp::Complex dc = p / (p + dsp::Complex{f.dc, 0});
    const double wanted = dsp::exp(2 * loop.N * sigma) / dsp::squared_magnitude(response(loop.allpass, p));
    R = wanted * dsp::squared_magnitude(p + dsp::Complex{f.shelf, 0}) / dsp::squared_magnitude(dc);
  }
};

}  // namespace

DecayGains solve_decay(const LoopDesign& loop, const DecayWish& wish, double sample_rate) {
  const Condition low(loop, wish.low_hz, wish.low_s, sample_rate);
  const Condition high(loop, wish.high_hz, wish.high_s, sample_rate);
  const double a = loop.filters.shelf;
  const double P_low = dsp::squared_magnitude(low.p), P_high = dsp::squared_magnitude(high.p);
  double k2 = 0, q = 0;
  // Re p is small against |p|, so the mixed term may lag one round behind.
  for (int i = 0; i < 30; ++i) {
    const double mixed = 2 * a * std::sqrt(k2 * q);
    const double r_low = low.R - mixed * low.p.re, r_high = high.R - mixed * high.p.re;
    q = (r_high - r_low) / (P_high - P_low);
    k2 = (r_low * P_high - r_high * P_low) / (a * a * (P_high - P_low));
    if (!(q >= 0 && q <= k2 && k2 < 1))
      throw std::invalid_argument(
          "t60: no passive loop decays like that, expected the higher frequency to die "
          "sooner but not too much sooner");
  }
  return {std::sqrt(k2), std::sqrt(q / k2)};
}

}  // namespace rigsound::tool
