// Elementary functions that give the same bits on every machine.
//
// Only + - * / and sqrt are used, in a written order, so compilers and processors that follow IEEE 754
// agree. Errors (measured in tests/unit/engine/elementary_test.cpp): exp, log, pow <= 4 ulp-ish 1e-15
// relative; sin, cos, tan, atan <= 1e-15 absolute for |x| <= 1e4.
#pragma once

#include <cmath>

namespace rigsound::dsp {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTwoPi = 2 * kPi;
constexpr double kLn2 = 0.69314718055994530942;
constexpr double kLn10 = 2.30258509299404568402;

double exp(double x) noexcept;  ///< e^x; 0 below -708, e^708 above 708
double log(double x) noexcept;  ///< ln x; -745 for x <= 0
double sin(double x) noexcept;  ///< x in radians
double cos(double x) noexcept;
struct SinCos {
  double sin, cos;
};
SinCos sin_cos(double x) noexcept;          ///< both, for little more than one
double atan(double x) noexcept;             ///< -pi/2...pi/2
double atan2(double y, double x) noexcept;  ///< -pi...pi; 0 at the origin

inline double tan(double x) noexcept { return sin(x) / cos(x); }
inline double pow(double base, double exponent) noexcept { return exp(exponent * log(base)); }
inline double gain_of_db(double db) noexcept { return exp(db * (kLn10 / 20)); }
inline double db_of_gain(double gain) noexcept { return log(gain) * (20 / kLn10); }

}  // namespace rigsound::dsp
