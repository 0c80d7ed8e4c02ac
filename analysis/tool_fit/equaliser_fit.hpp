// A few bells that bend one spectrum towards another.
#pragma once

#include <vector>

#include "rigsound/tool_model.hpp"

namespace rigsound::analysis {

/// At most kMaxToolBands bells whose sum comes near `wanted_db` at `centre_hz`, up to a constant; each is
/// added only if it helps by 0.15 dB on average. Thread: OFF.
std::vector<ToolBand> fit_bells(const std::vector<double>& centre_hz, const std::vector<double>& wanted_db);

}  // namespace rigsound::analysis
