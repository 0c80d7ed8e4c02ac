#include "tool/design/decay_solver.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "tool/design/loop_response.hpp"

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
    const double wanted =
        dsp::exp(2 * loop.delay_samples * sigma) / dsp::squared_magnitude(response(loop.allpass, p));
    R = wanted * dsp::squared_magnitude(p + dsp::Complex{f.shelf, 0}) / dsp::squared_magnitude(dc);
  }

  /// The reflection that meets it beside a shelf of gain g; falls as g rises.
  double k_with(double g, double shelf) const {
    return std::sqrt(R / dsp::squared_magnitude(dsp::Complex{shelf, 0} + g * p));
  }
};

constexpr double kMostReflection = 0.9999;

/// Milliseconds to a tenth.
std::string ms(double tenths) {
  const auto whole = static_cast<long>(tenths);
  return std::to_string(whole / 10) + "." + std::to_string(whole % 10) + " ms";
}

std::string hz(double frequency) { return std::to_string(static_cast<long>(frequency + 0.5)) + " Hz"; }

/// Why no k and g grant the wish, and what they would; times rounded into the range.
std::string refusal(LoopDesign loop, const DecayWish& wish, double sample_rate) {
  const auto tenths = [&](double k, double g, double frequency) {
    loop.filters.shelf_gain = g;
    return 1e4 * t60_samples(decay_rate(loop, k, dsp::kTwoPi * frequency / sample_rate)) / sample_rate;
  };
  const Condition low(loop, wish.low_hz, wish.low_s, sample_rate);
  const double shelf = loop.filters.shelf, k_flat = low.k_with(1, shelf);
  if (!(k_flat < kMostReflection))
    return "t60: " + ms(1e4 * wish.low_s) + " at " + hz(wish.low_hz) + " is too long, expected at most " +
           ms(std::floor(0.99 * tenths(kMostReflection, 1, wish.low_hz)));
  double steepest = 0, flat = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (steepest + flat);
    (low.k_with(middle, shelf) < kMostReflection ? flat : steepest) = middle;
  }
  const double shortest = std::ceil(1.01 * tenths(low.k_with(flat, shelf), flat, wish.high_hz));
  const double longest = std::floor(0.99 * tenths(k_flat, 1, wish.high_hz));
  return "t60: no passive loop decays like that, expected " + ms(shortest) + "..." + ms(longest) + " at " +
         hz(wish.high_hz) + " beside " + ms(1e4 * wish.low_s) + " at " + hz(wish.low_hz);
}

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
    if (!(q >= 0 && q <= k2 && k2 < kMostReflection * kMostReflection))
      throw std::invalid_argument(refusal(loop, wish, sample_rate));
  }
  return {std::sqrt(k2), std::sqrt(q / k2)};
}

}  // namespace rigsound::tool
