// The rate that engine tests play at where they say no other, and differences as ears count them.
#pragma once

#include <cmath>
#include <vector>

namespace rigsound::tests {

inline constexpr double kRate = 48000;  // Hz

/// How far a lies above b.
inline double cents(double a, double b) { return 1200 * std::log2(a / b); }

/// The rest of a sound of that rate.
inline std::vector<double> after(const std::vector<double>& sound, double seconds, double rate = kRate) {
  return {sound.begin() + static_cast<std::ptrdiff_t>(seconds * rate), sound.end()};
}

}  // namespace rigsound::tests
