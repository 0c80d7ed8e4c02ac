// How far the sound of a sound set follows the feed pressure.
#pragma once

#include <string_view>
#include <vector>

#include "rigsound/options.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound::scene {

/// Beyond the outermost bank a parameter goes on by its trend; from `feed_bar` on it follows by less than
/// half of that, or not at all.
struct TrendLimit {
  std::string_view parameter;  ///< rate, level, decay, gap variation, amplitude variation or brightness
  double feed_bar;             ///< within the signal's range
};

/// The banks of one rod count and rock on the feed axis.
struct FeedReach {
  int rods, rock;  ///< rock -1: any
  int banks;
  double lowest_bar, highest_bar;  ///< of the banks
  std::vector<TrendLimit> limits;  ///< below the lowest, then above the highest; empty: it follows everywhere
};

/// One entry a series that has banks, rising in rock and rods. Thread: OFF.
std::vector<FeedReach> feed_reach(const SoundSet& sounds, const SceneOptions& options);

}  // namespace rigsound::scene
