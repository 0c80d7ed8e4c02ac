// What a tool model sounds like when it is struck once.
#pragma once

#include <cstddef>
#include <vector>

#include "rigsound/tool_model.hpp"

namespace rigsound::analysis {

/// `samples` at kAnalysisRate, struck once kBeforeBlow samples after the start, without bounces or chance.
/// Thread: OFF.
std::vector<double> one_blow(const ToolModel& model, std::size_t samples);

}  // namespace rigsound::analysis
