// Passes over samples in vectors: the same bits at every width. Thread: RT.
#pragma once

#include "rigsound/dsp/lane_width.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

/// Squares of samples that come in pairs: of the first of each pair in lane 0, of the second in lane 1.
struct Squares {
  Lanes sum{}, most{};
};

/// A signal of one channel on its way to two.
struct Placed {
  const double* x;
  Lanes gains;  ///< to the first and the second channel
};

/// Taken by with_widest<Passes>().
template <LaneWidth kWidth>
struct Passes {
  /// out[n] += gain x[n], for n < count.
  static void add_scaled(double gain, const float* x, int count, double* out) noexcept;

  /// frames[n] = what is placed, summed, for n < count; `count`, here and below, a multiple of 8.
  static void place(const Placed& only, int count, Lanes* frames) noexcept;
  static void place(const Placed& first, const Placed& second, int count, Lanes* frames) noexcept;
  /// frames[n] += what is placed.
  static void add_placed(const Placed& more, int count, Lanes* frames) noexcept;

  /// Of `count` samples.
  static Squares squares(const double* x, int count) noexcept;

  /// `count` frames in single precision, interleaved; their squares before rounding.
  static Squares narrow(const Lanes* frames, int count, float* out) noexcept;

  /// highest[i] = the highest magnitude on both channels of frames 8 i ... 8 i + 7.
  static void highest_of_eights(const Lanes* frames, int count, double* highest) noexcept;
};

}  // namespace rigsound::dsp
