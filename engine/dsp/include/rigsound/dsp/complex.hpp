// Complex numbers in written arithmetic: std::complex divides and multiplies differently per compiler.
#pragma once

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

struct Complex {
  double re = 0, im = 0;
};

constexpr Complex operator+(Complex a, Complex b) noexcept { return {a.re + b.re, a.im + b.im}; }
constexpr Complex operator-(Complex a, Complex b) noexcept { return {a.re - b.re, a.im - b.im}; }
constexpr Complex operator*(Complex a, Complex b) noexcept {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
constexpr Complex operator*(double a, Complex b) noexcept { return {a * b.re, a * b.im}; }
constexpr double squared_magnitude(Complex a) noexcept { return a.re * a.re + a.im * a.im; }
constexpr Complex operator/(Complex a, Complex b) noexcept {
  const double n = squared_magnitude(b);
  return {(a.re * b.re + a.im * b.im) / n, (a.im * b.re - a.re * b.im) / n};
}
inline double magnitude(Complex a) noexcept { return std::sqrt(squared_magnitude(a)); }
inline double angle(Complex a) noexcept { return atan2(a.im, a.re); }
inline Complex exp(Complex a) noexcept {
  const double r = exp(a.re);
  return {r * cos(a.im), r * sin(a.im)};
}

}  // namespace rigsound::dsp
