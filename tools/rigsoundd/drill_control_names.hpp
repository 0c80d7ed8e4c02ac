// The six live controls by name, with their ranges.
#pragma once

#include <string_view>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::daemon {

struct ControlInfo {
  std::string_view name, unit;
  float min, max;
  bool zero_allowed;  ///< 0 too, which means the machine's or the bank's own
  float DrillControls::*field;
};

constexpr ControlInfo kDrillControls[] = {
    {"mean_frequency_hz", "Hz", 1, 100, true, &DrillControls::mean_frequency_hz},
    {"mean_amplitude_db", "dB", -60, 24, false, &DrillControls::mean_amplitude_db},
    {"deviation_time", "", 0, 4, false, &DrillControls::deviation_time},
    {"deviation_amplitude", "", 0, 4, false, &DrillControls::deviation_amplitude},
    {"attack_factor", "", 0.1F, 10, false, &DrillControls::attack_factor},
    {"decay_factor", "", 0.25F, 10, false, &DrillControls::decay_factor},
};

}  // namespace rigsound::daemon
