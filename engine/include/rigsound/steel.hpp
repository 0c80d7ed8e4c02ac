// A bar of steel, and how fast it shall stop ringing.
#pragma once

#include "rigsound/machine/limits.hpp"

namespace rigsound {

constexpr double kSpeedOfSound = 5200;  ///< m/s, thin rod of steel (jackhammer paper, section 2)
constexpr double kPoisson = 0.30;       ///< Poisson's ratio of steel
constexpr double kHighestMode = 0.41;   ///< that is tuned, as a share of the sample rate

/// A free-free round steel bar.
struct Bar {
  double length_m = 0.5;      ///< the designer is measured from 0.3 to 1 m
  double diameter_m = 0.025;  ///< measured from 15 to 50 mm; at most a quarter of the length
};

template <class Archive>
void fields(Archive& a, Bar& o) {
  a("length_m", o.length_m, Range{0.2, 1.2, "m"});
  a("diameter_m", o.diameter_m, Range{0.010, 0.080, "m"});
}

/// Two wanted decay times (T60) at two frequencies of one family; time 0: none wanted.
struct DecayWish {
  double low_hz = 0, low_s = 0;
  double high_hz = 0, high_s = 0;
};

template <class Archive>
void fields(Archive& a, DecayWish& o) {
  constexpr Range kTimes = Range{0.001, 30, "s"}.or_zero();
  a("low_hz", o.low_hz, Range{50, 18000, "Hz"}.or_zero());
  a("low_s", o.low_s, kTimes);
  a("high_hz", o.high_hz, Range{50, kHighestMode * kMaxSampleRate, "Hz"}.or_zero());
  a("high_s", o.high_s, kTimes);
}

/// Decay of one family: given outright, or through a wish that replaces k and the shelf's gain.
struct Decay {
  double reflection_min = 0.83;  ///< reflection while the tool is in contact, at most that of the free one
  double reflection_max = 0.89;  ///< and while it is free
  double shelf_gain = 0.8;       ///< of the loop's shelf above its corner
  double shelf_hz = 6000;        ///< its corner, at most kHighestCorner of the sample rate
  DecayWish wish;                ///< of the free tool; k_min / k_max keeps its ratio
};

template <class Archive>
void fields(Archive& a, Decay& o) {
  constexpr Range kReflections{0.01, 0.9999};
  a("k_min", o.reflection_min, kReflections);
  a("k_max", o.reflection_max, kReflections);
  a("shelf_gain", o.shelf_gain, Range{0, 1});
  a("shelf_hz", o.shelf_hz, Range{100, kHighestCorner * kMaxSampleRate, "Hz"});
  a("t60", o.wish);
}

}  // namespace rigsound
