// What `rigsound check` found, for programs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "figure_row.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/feed_reach.hpp"

namespace rigsound::tools {

/// Of the sound set that the rig plays.
struct SoundCounts {
  std::size_t banks = 0, clicks = 0, rocks = 0, tools = 0;
  std::string background;
};

/// What check knows once the rig is found to be right.
struct CheckedRig {
  const config::Rig& rig;
  SoundCounts sounds;
  std::vector<std::string> rocks;  ///< names, by FeedReach::rock
  std::vector<scene::FeedReach> reach;
  std::vector<std::string> missing;  ///< what no bus delivers although the engine needs it
};

constexpr std::string_view kStaleActions[] = {"hold", "idle", "mute"};

/// Thread: OFF.
Json check_json(const CheckedRig& checked);

}  // namespace rigsound::tools
