// How a drill's clicks change with the feed pressure, from banks recorded at several.
#pragma once

#include <optional>
#include <vector>

#include "rigsound/sound_set.hpp"

namespace rigsound::analysis {

/// A bank, the feed pressure it was recorded at and its spectral_tilt(). The clicks themselves may be left
/// out.
struct FedBank {
  double feed_bar = 0;
  ClickBank bank;
  double tilt_db_per_octave = 0;
};

constexpr int kFewestFeeds = 3;
constexpr double kFeedsApart_bar = 2;  ///< nearer ones count as one

/// The slopes of a series (one rod count, one rock) by a regression that outliers do not move; rods and rock
/// are left as they are by default. Nothing when the series has fewer than kFewestFeeds feeds. Thread: OFF.
std::optional<FeedLaws> fit_feed_laws(const std::vector<FedBank>& series);

}  // namespace rigsound::analysis
