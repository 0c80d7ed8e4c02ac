#include "rigsound/dsp/elementary.hpp"

#include <cstdint>
#include <cstring>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {
namespace {

double from_bits(std::uint64_t bits) noexcept {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

std::uint64_t to_bits(double x) noexcept {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof x);
  return bits;
}

// ln 2 in two parts: the first has 32 trailing zero bits, so k * kLn2High is exact for |k| < 2^11.
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;

// pi/2 in three parts of 33 bits each (Cody and Waite), exact products for |k| < 2^20.
constexpr double kHalfPi1 = 1.57079632673412561417e+00;
constexpr double kHalfPi2 = 6.07710050630396597660e-11;
constexpr double kHalfPi3 = 2.02226624879595063154e-21;

/// sin x for |x| <= pi/4: Taylor to x^17, remainder below 1e-18.
double sin_core(double x) noexcept {
  const double z = x * x;
  double p = 1.0 / 355687428096000.0;
  p = p * z - 1.0 / 1307674368000.0;
  p = p * z + 1.0 / 6227020800.0;
  p = p * z - 1.0 / 39916800.0;
  p = p * z + 1.0 / 362880.0;
  p = p * z - 1.0 / 5040.0;
  p = p * z + 1.0 / 120.0;
  p = p * z - 1.0 / 6.0;
  return x + x * (z * p);
}

/// cos x for |x| <= pi/4: Taylor to x^18.
double cos_core(double x) noexcept {
  const double z = x * x;
  double p = -1.0 / 6402373705728000.0;
  p = p * z + 1.0 / 20922789888000.0;
  p = p * z - 1.0 / 87178291200.0;
  p = p * z + 1.0 / 479001600.0;
  p = p * z - 1.0 / 3628800.0;
  p = p * z + 1.0 / 40320.0;
  p = p * z - 1.0 / 720.0;
  p = p * z + 1.0 / 24.0;
  return 1.0 - (0.5 * z - z * (z * p));
}

/// x minus k quarter turns; quadrant gets k mod 4.
double reduce(double x, int& quadrant) noexcept {
  const double k = std::floor(x * (2 / kPi) + 0.5);
  quadrant = static_cast<int>(static_cast<std::int64_t>(k) & 3);
  return ((x - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
}

double by_quadrant(double x, int quadrant) noexcept {
  const double v = (quadrant & 1) ? cos_core(x) : sin_core(x);
  return (quadrant & 2) ? -v : v;
}

}  // namespace

double exp(double x) noexcept {
  if (!(x > -708.0)) return 0.0;
  if (x > 708.0) x = 708.0;
  const double k = std::floor(x * (1 / kLn2) + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= ln2 / 2
  double p = 1.0 / 6227020800.0;                      // Taylor to r^13, remainder below 1e-17
  p = p * r + 1.0 / 479001600.0;
  p = p * r + 1.0 / 39916800.0;
  p = p * r + 1.0 / 3628800.0;
  p = p * r + 1.0 / 362880.0;
  p = p * r + 1.0 / 40320.0;
  p = p * r + 1.0 / 5040.0;
  p = p * r + 1.0 / 720.0;
  p = p * r + 1.0 / 120.0;
  p = p * r + 1.0 / 24.0;
  p = p * r + 1.0 / 6.0;
  p = p * r + 0.5;
  const double mantissa = 1.0 + (r + r * (r * p));
  return mantissa * from_bits(static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023) << 52);
}

double log(double x) noexcept {
  if (!(x > 0)) return -745.0;
  double scale = 0;
  if (x < 2.2250738585072014e-308) x *= 18014398509481984.0, scale = -54;  // subnormal: lift by 2^54
  const std::uint64_t bits = to_bits(x);
  double k = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023) + scale;
  double m = from_bits((bits & 0x000fffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 1.4142135623730951) m *= 0.5, k += 1;
  // ln m = 2 atanh s, s = (m-1)/(m+1), |s| <= 0.1716: series to s^21, remainder below 1e-18
  const double s = (m - 1) / (m + 1), z = s * s;
  double p = 1.0 / 21.0;
  p = p * z + 1.0 / 19.0;
  p = p * z + 1.0 / 17.0;
  p = p * z + 1.0 / 15.0;
  p = p * z + 1.0 / 13.0;
  p = p * z + 1.0 / 11.0;
  p = p * z + 1.0 / 9.0;
  p = p * z + 1.0 / 7.0;
  p = p * z + 1.0 / 5.0;
  p = p * z + 1.0 / 3.0;
  const double ln_m = 2 * s + 2 * s * (z * p);
  return k * kLn2High + (ln_m + k * kLn2Low);
}

double sin(double x) noexcept {
  int quadrant;
  const double r = reduce(x, quadrant);
  return by_quadrant(r, quadrant);
}

double cos(double x) noexcept {
  int quadrant;
  const double r = reduce(x, quadrant);
  return by_quadrant(r, (quadrant + 1) & 3);
}

SinCos sin_cos(double x) noexcept {
  int quadrant;
  const double r = reduce(x, quadrant), z = r * r;
  // sin_core and cos_core side by side, term by term.
  Lanes p = {1.0 / 355687428096000.0, -1.0 / 6402373705728000.0};
  p = p * z + Lanes{-1.0 / 1307674368000.0, 1.0 / 20922789888000.0};
  p = p * z + Lanes{1.0 / 6227020800.0, -1.0 / 87178291200.0};
  p = p * z + Lanes{-1.0 / 39916800.0, 1.0 / 479001600.0};
  p = p * z + Lanes{1.0 / 362880.0, -1.0 / 3628800.0};
  p = p * z + Lanes{-1.0 / 5040.0, 1.0 / 40320.0};
  p = p * z + Lanes{1.0 / 120.0, -1.0 / 720.0};
  p = p * z + Lanes{-1.0 / 6.0, 1.0 / 24.0};
  const double s = r + r * (z * p[0]), c = 1.0 - (0.5 * z - z * (z * p[1]));
  const double sine = (quadrant & 1) ? c : s, cosine = (quadrant & 1) ? s : c;
  return {(quadrant & 2) ? -sine : sine, ((quadrant + 1) & 2) ? -cosine : cosine};
}

double atan(double x) noexcept {
  // Three halvings, atan x = 2 atan(x / (1 + sqrt(1 + x^2))), bring |x| below 0.1.
  if (x > 1) return kPi / 2 - atan(1 / x);
  if (x < -1) return -kPi / 2 - atan(1 / x);
  for (int i = 0; i < 3; ++i) x = x / (1 + std::sqrt(1 + x * x));
  const double z = x * x;
  double p = -1.0 / 19.0;
  p = p * z + 1.0 / 17.0;
  p = p * z - 1.0 / 15.0;
  p = p * z + 1.0 / 13.0;
  p = p * z - 1.0 / 11.0;
  p = p * z + 1.0 / 9.0;
  p = p * z - 1.0 / 7.0;
  p = p * z + 1.0 / 5.0;
  p = p * z - 1.0 / 3.0;
  return 8 * (x + x * (z * p));
}

double atan2(double y, double x) noexcept {
  if (x > 0) return atan(y / x);
  if (x < 0) return y >= 0 ? atan(y / x) + kPi : atan(y / x) - kPi;
  return y > 0 ? kPi / 2 : y < 0 ? -kPi / 2 : 0.0;
}

}  // namespace rigsound::dsp
