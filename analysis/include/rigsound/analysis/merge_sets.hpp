// Sound sets that were filled apart, as one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/progress.hpp"

namespace rigsound::analysis {

struct MergedSets {
  int banks = 0, tools = 0, backgrounds = 0;  ///< in `out` now
  std::vector<std::string> notes;             ///< one line each: laws that the series now give
};

/// Puts everything that the soundset.toml of `sets` names into `out`, which may be a sound set that is there:
/// its text and its files stay. What two sets name alike must be the same, byte by byte. Rocks keep the order
/// of `out`, then of `sets`. Laws are fitted where the joined banks give some and none are written. All of it
/// or nothing. Errors: InputError for two things of one name that differ, a set that is `out`, or one that
/// cannot be read; DeviceError for the disk. Thread: OFF.
MergedSets merge_sets(const std::vector<std::filesystem::path>& sets, const std::filesystem::path& out,
                      const Progress& progress = {});

}  // namespace rigsound::analysis
