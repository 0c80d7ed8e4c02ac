#include "tool/design/loop_response.hpp"

#include <algorithm>

namespace rigsound::tool {
namespace {

using dsp::Complex;

constexpr Complex kOne{1, 0};

/// -pi...pi
double wrapped(double phase) noexcept { return phase - dsp::kTwoPi * std::floor(phase / dsp::kTwoPi + 0.5); }

/// d ln(F A) / dp, term by term.
Complex log_slope(const LoopDesign& loop, Complex p) noexcept {
  const LoopFilters& f = loop.filters;
  Complex sum = kOne / p - kOne / (p + Complex{f.dc, 0});
  sum = sum + Complex{f.shelf_gain, 0} / (f.shelf_gain * p + Complex{f.shelf, 0}) -
        kOne / (p + Complex{f.shelf, 0});
  for (int i = 0; i < loop.allpass.sections; ++i) {
    const auto [b, c] = loop.allpass.section[static_cast<std::size_t>(i)];
    const Complex even = p * p + Complex{c, 0}, odd = b * p;
    sum = sum + (2 * p - Complex{b, 0}) / (even - odd) - (2 * p + Complex{b, 0}) / (even + odd);
  }
  const Complex a{loop.allpass.a, 0};
  return sum - static_cast<double>(loop.allpass.first_orders) * (kOne / (a - p) + kOne / (a + p));
}

/// ln(k F A e^(-N s)); zero at a pole.
Complex log_loop(const LoopDesign& loop, double k, Complex s) noexcept {
  const Complex p = bilinear(s), h = response(loop.filters, p) * response(loop.allpass, p);
  return {0.5 * dsp::log(k * k * dsp::squared_magnitude(h)) - loop.delay_samples * s.re,
          wrapped(dsp::angle(h) - loop.delay_samples * s.im)};
}

Complex log_loop_slope(const LoopDesign& loop, Complex s) noexcept {
  const Complex p = bilinear(s);
  return 0.5 * ((kOne - p * p) * log_slope(loop, p)) - Complex{static_cast<double>(loop.delay_samples), 0};
}

}  // namespace

Complex bilinear(Complex s) noexcept {
  const Complex z = dsp::exp(s);
  return (z - kOne) / (z + kOne);
}

double lag(const Allpass& allpass, double omega) noexcept {
  // Each section turns by less than half a turn (lag / 2 = arg(c - O^2 + i b O)), so one running product
  // and a count of its crossings of the negative axis replace an arc tangent a section.
  const double O = dsp::tan(omega / 2), O2 = O * O;
  Complex product = kOne;
  int turns = 0;
  const auto turn = [&](Complex by) {
    const Complex next = product * by;
    if (product.im >= 0 && next.im < 0) ++turns;
    product = next;
  };
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
    turn({c - O2, b * O});
  }
  for (int i = 0; i < allpass.first_orders; ++i) turn({allpass.a, O});
  return 2 * (dsp::angle(product) + dsp::kTwoPi * turns);
}

double group_delay(const Allpass& allpass, double omega) noexcept {
  const double O = dsp::tan(omega / 2), O2 = O * O;
  double sum = 0;
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
    const double x = c - O2, y = b * O;
    sum += 2 * b * (c + O2) / (x * x + y * y);
  }
  const double a = allpass.a;
  return (sum + allpass.first_orders * 2 * a / (a * a + O2)) * 0.5 * (1 + O2);
}

double lag(const LoopFilters& filters, double omega) noexcept {
  return -dsp::angle(response(filters, {0, dsp::tan(omega / 2)}));
}

Complex response(const Allpass& allpass, Complex p) noexcept {
  Complex h = kOne;
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
    const Complex even = p * p + Complex{c, 0}, odd = b * p;
    h = h * ((even - odd) / (even + odd));
  }
  const Complex a{allpass.a, 0}, first = (a - p) / (a + p);
  for (int i = 0; i < allpass.first_orders; ++i) h = h * first;
  return h;
}

Complex response(const LoopFilters& filters, Complex p) noexcept {
  const Complex dc = p / (p + Complex{filters.dc, 0});
  return dc * ((filters.shelf_gain * p + Complex{filters.shelf, 0}) / (p + Complex{filters.shelf, 0}));
}

Pole closed_loop_pole(const LoopDesign& loop, double k, double omega) noexcept {
  Complex s{decay_rate(loop, k, omega), omega};
  for (int i = 0; i < 40; ++i) {
    Complex step = log_loop(loop, k, s) / log_loop_slope(loop, s);
    const double size = dsp::magnitude(step), most = 0.1 * omega;
    if (size > most) step = (most / size) * step;  // stay with the mode asked for
    s = s - step;
    if (size < 1e-14) break;
  }
  return {s.im, s.re};
}

double decay_rate(const LoopDesign& loop, double k, double omega) noexcept {
  double sigma = 0;
  for (int i = 0; i < 20; ++i) {
    const Complex s{sigma, omega};
    const double step = log_loop(loop, k, s).re / log_loop_slope(loop, s).re;
    sigma = std::clamp(sigma - step, -1.0, 0.0);
    if (std::fabs(step) < 1e-15) break;
  }
  return sigma;
}

}  // namespace rigsound::tool
