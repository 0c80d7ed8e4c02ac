// Duller or brighter: a slope over the octaves from 125 Hz to 8 kHz.
#pragma once

#include <array>

namespace rigsound::drill {

/// First-order high shelves two octaves apart, each of twice the slope: together straight to 1 dB up to 6 dB
/// an octave. What lies below stays as it is, what lies above goes along.
constexpr std::array<double, 3> kShelves_hz = {250, 1000, 4000};

/// Power gain at `frequency_hz` of a tilt by `db_per_octave`. Thread: OFF.
double tilt_power(double db_per_octave, double frequency_hz);

class TiltFilter {
 public:
  explicit TiltFilter(double sample_rate);  ///< Thread: OFF

  /// kChunk samples in place. Costs nothing at tilt 0, and changes nothing then. Thread: RT.
  void process(double db_per_octave, double* x) noexcept;

  bool rests() const noexcept;  ///< zeros give zeros

  void reset() noexcept;  ///< Thread: RT

 private:
  struct Shelf {
    double warp;                    ///< 1 / tan(pi f / rate)
    double b0 = 1, b1 = 0, a1 = 0;  ///< y = b0 x + b1 x_1 - a1 y_1
    double state = 0;
  };
  void place(double db_per_octave) noexcept;

  std::array<Shelf, kShelves_hz.size()> shelves_;
  double tilt_ = 0;
};

}  // namespace rigsound::drill
