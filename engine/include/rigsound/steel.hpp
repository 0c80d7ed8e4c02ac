// A bar of steel, and how fast it shall stop ringing.
#pragma once

namespace rigsound {

constexpr double kSpeedOfSound = 5200;  ///< m/s, thin rod of steel (jackhammer paper, section 2)
constexpr double kPoisson = 0.30;       ///< Poisson's ratio of steel

/// A free-free round steel bar.
struct Bar {
  double length_m = 0.5;      ///< m, 0.3...1.0; the designer is measured there and tries 0.2...1.2
  double diameter_m = 0.025;  ///< m, 0.015...0.050; tries 0.010...0.080, at most a quarter of the length
};

/// Two wanted decay times (T60) at two frequencies of one family; time 0: none wanted.
struct DecayWish {
  double low_hz = 0, low_s = 0;
  double high_hz = 0, high_s = 0;
};

/// Decay of one family: given outright, or through a wish that replaces k and the shelf's gain.
struct Decay {
  double reflection_min = 0.83;  ///< reflection while the tool is in contact, 0 < min <= max < 1
  double reflection_max = 0.89;  ///< and while it is free
  double shelf_gain = 0.8;       ///< of the loop's shelf above its corner, 0...1
  double shelf_hz = 6000;        ///< its corner
  DecayWish wish;                ///< of the free tool; k_min / k_max keeps its ratio
};

}  // namespace rigsound
