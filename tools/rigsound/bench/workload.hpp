// What `bench` plays: sounds from formulas, the user's rig, or the rig on a recorded bus.
#pragma once

#include <string>

#include "bench/layer_costs.hpp"
#include "log_arguments.hpp"

namespace rigsound::tools {

/// One boom with bar and equaliser that drills at 1800 r/min, for `seconds`, after a second to settle.
Workload formula_workload(double seconds);

/// Every boom of the rig drills at its normal feed, at 1800 r/min. Errors: InputError. Thread: OFF.
Workload rig_workload(const std::string& rig, double seconds);

/// The log from its start to its end or to `seconds` of it, if it is longer: starts and changes count.
/// Errors: InputError. Thread: OFF.
Workload log_workload(const std::string& rig, const LogArguments& log, double seconds);

}  // namespace rigsound::tools
