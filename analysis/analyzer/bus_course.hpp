// What a recorded bus said of a drill, as a course over time.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "rigsound/config/rig.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::analysis {

/// The first boom at one moment, after the rig's safety rules.
struct BusMoment {
  std::optional<Situation> situation;  ///< by the rig's thresholds; none while the hammer rests
  double feed_bar = 0;
  double percussion_bar = 0;  ///< 0: the bus never said
  double rpm = 0;             ///< of the diesel
  int rods = 0;               ///< 0: the bus never said
  int rock = -1;              ///< -1: the bus never said
};

constexpr double kBusStep_s = 0.02;

struct BusCourse {
  std::vector<BusMoment> moments;  ///< every kBusStep_s, from the first entry of the log to its last
};

/// Errors: InputError for a log that cannot be read or says nothing of the feed. Thread: OFF.
BusCourse read_bus_course(const config::Rig& rig, const std::filesystem::path& log);

}  // namespace rigsound::analysis
