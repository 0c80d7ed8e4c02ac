// Delays and junctions of the longitudinal string: where the ends of rods and sleeves fall on the sample
// grid.
#pragma once

#include "rigsound/string_model.hpp"

namespace rigsound::string {

constexpr int kMaxLines = kMaxRods + 1;  ///< the shank's and every rod's
constexpr int kSleeveStep = 4;           ///< a sleeve's round trip is 1, 2 or 4 of these, samples
constexpr double kDensity = 7850;        ///< steel, kg/m^3

/// A string of so many rods at one sample rate. All delay stands in the upward direction and is a round
/// trip's (retimed: the downward wave is not delayed, and what the shank sends and gets is the same to the
/// bit).
struct StringTuning {
  int joints = 0;             ///< sleeves; joint j lies between line j and line j + 1
  int delay[kMaxLines] = {};  ///< round trips, whole samples, the shank's first
  // What is beyond: taps[0] x[n] + taps[1] x[n-1] + taps[2] x[n-2] delays the rods' waves by 1 + fraction
  // more.
  bool has_fractions = false;
  double fraction[kMaxLines] = {};  ///< -0.5...0.5, no line's but a rod's
  int block = kSleeveStep;  ///< samples that can be computed line by line: a chunk, two sleeves or one
  int sleeve_steps = 1;
  double sleeve_impedance = 1;  ///< of a sleeve that long with the mass and compliance of the real one
  double head_delay = 2;        ///< 1.5...2.5 samples, a second-order Thiran allpass at the shank's free end
  double loss_middle = 1,
         loss_side = 0;  ///< reflection there: loss_middle x[n-1] + loss_side (x[n] + x[n-2])

  /// From sleeve to rod and back: (Z' - Z) / (Z' + Z).
  double reflection() const noexcept { return (sleeve_impedance - 1) / (sleeve_impedance + 1); }

  /// Once down the string and back, samples.
  double round_trip() const noexcept;
};

/// Positions are rounded cumulatively, so that no joint is off by more than a quarter of a sample each way
/// and the whole string not at all. `rods` 1...kMaxRods instead of the model's. Thread: OFF.
StringTuning tune_string(const StringModel& model, int rods, double sample_rate);

/// Round trip over `length_m`, samples.
double round_trip_samples(double length_m, double sample_rate) noexcept;

/// Wave impedance of the rod A sqrt(E rho), kg/s.
double rod_impedance(const StringModel& model) noexcept;

/// Lagrange's interpolator of second order: 1 + fraction samples at 0 Hz, never louder than its input, since
/// |H|^2 = 1 - fraction^2 (1 - fraction^2) (1 - cos w)^2.
struct Lagrange {
  double tap[3];
};
Lagrange lagrange(double fraction) noexcept;

/// The second-order Thiran allpass (a2 + a1 z^-1 + z^-2) / (1 + a1 z^-1 + a2 z^-2), its delay flat at 0 Hz.
struct Thiran {
  double a1 = 0, a2 = 0;
};
Thiran thiran(double delay) noexcept;

}  // namespace rigsound::string
