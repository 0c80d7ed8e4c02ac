// One impact of the simulated drill, as the feed has it.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/analysis/click_train.hpp"
#include "simulate/drilling_laws.hpp"
#include "simulate/split_mix.hpp"

namespace rigsound::analysis {

/// The envelope of a click; the attack is the same at every feed.
ClickEnvelope drilling_envelope(const DrillingPoint& point);

/// Root mean square frequency of a click, Hz: the figure for its brightness. Thread: OFF.
double brightness_hz(const DrillingPoint& point, int rods);

/// Draws clicks one after the other: enveloped noise and ringing of the string, coloured. Thread: OFF.
class DrillingClicks {
 public:
  /// `noise_seed` and `variation_seed`: streams of the grains and of what changes between them. The string of
  /// `rods` rods of 3.66 m rings at the multiples of c / (2 L).
  DrillingClicks(int rods, std::uint64_t noise_seed, std::uint64_t variation_seed);

  /// The next click, of L2 norm one; it has decayed by 70 dB at its end.
  std::vector<double> draw(const DrillingPoint& point);

 private:
  std::vector<double> draw_ringing(int length);

  std::vector<double> modes_hz_;
  SplitMix noise_, variation_;
};

}  // namespace rigsound::analysis
