// What a bus said while a simulated drill was recorded: messages of config/dbc/rig.dbc, as candump -l writes
// them.
#pragma once

#include <functional>
#include <string>

namespace rigsound::analysis {

/// What is on the bus at a moment of the recording.
struct DrillMoment {
  double feed_bar = 0;  ///< 0...642
  double diesel_rpm = 0;
  int rods = 1;
  bool hammering = false;
};

/// EEC1 (speed) every 20 ms and DRILL1 (feed, hammer, rods) every 50 ms from 0 to `seconds`; the first frame
/// comes at 0. Thread: OFF.
std::string drill_bus_log(double seconds, const std::function<DrillMoment(double time_s)>& moment);

}  // namespace rigsound::analysis
