// Which stretch of a recording is which situation and feed, by the bus recorded beside it.
#pragma once

#include <string>
#include <vector>

#include "analyzer/bus_course.hpp"
#include "rigsound/analysis/labels.hpp"

namespace rigsound::analysis {

struct BusParts {
  std::vector<Label> labels;       ///< in the order of time, of the recording's own
  std::vector<std::string> notes;  ///< what was left out, and why
};

/// A part for every stretch in which situation, rods and rock stay the same, less what the machine needs to
/// settle at its ends; a stretch of drilling whose feed moves is cut into parts over which it moves by at
/// most kPartFeed_bar. Each has the mean feed, percussion pressure and speed of its own time. `offset_s`:
/// when in the recording the log begins; may be negative. `rocks`: names of the bus's rock numbers, "" where
/// unknown. Thread: OFF.
BusParts bus_parts(const BusCourse& course, double offset_s, double recording_s,
                   const std::vector<std::string>& rocks);

constexpr double kPartFeed_bar = 10;
constexpr double kSettle_s = 0.3;  ///< at each end of a stretch
constexpr double kShortestDrilling_s =
    2;  ///< of a part; of rattling, which comes in bursts, kShortestBurst_s
constexpr double kShortestBurst_s = 0.5;

}  // namespace rigsound::analysis
