// What the simulated drill does at each feed pressure: the laws that an analysis of its recordings has to
// find.
#pragma once

#include <cstdint>

#include "rigsound/sound_set.hpp"
#include "simulate/biquad_cascade.hpp"

namespace rigsound::analysis {

/// The drill at one feed pressure and rod count.
struct DrillingPoint {
  double rate_hz;             ///< impacts a second, those that do not come counted in
  double gap_variation;       ///< standard deviation of a gap over the mean gap
  double miss_share;          ///< share of impacts that do not come
  double norm;                ///< mean L2 norm of a click, full scale = 1
  double norm_variation;      ///< standard deviation of the norms over their mean
  double decay;               ///< alpha_d, 1/sample at 48 kHz
  double tilt_db_per_octave;  ///< of the spectrum, around 1 kHz
  double ring_share;          ///< of a click's energy: in the modes of the string, the rest is noise
  double diesel_rpm;
};

/// The colour of a click: what radiates it, tilted as `point` says.
BiquadCascade drilling_colour(const DrillingPoint& point);

/// ln rate, ln norm, ln decay and the tilt are straight over the feed: underfeed is quick, irregular and
/// bright, rings long and misses impacts; overfeed is slower, steady, short and dull. More rods: slower,
/// softer, longer ringing and duller. Thread: any.
class DrillingLaws {
 public:
  /// The machine is the same for every seed, only its rate at the normal feed differs a little.
  explicit DrillingLaws(std::uint64_t seed);

  /// `feed_bar` 0...300, `rods` 1...20.
  DrillingPoint at(double feed_bar, int rods) const;

  /// As soundset.toml writes them; the variations stop falling where they would reach nothing.
  static FeedLaws slopes();

  static constexpr double kUnderfeed_bar = 40, kNormal_bar = 90, kOverfeed_bar = 150;
  static constexpr double kPercussion_bar = 150;
  static constexpr double kNormalRms = 0.04;  ///< of one rod at the normal feed, full scale = 1

 private:
  double rate_hz_;  ///< at the normal feed with one rod
};

}  // namespace rigsound::analysis
