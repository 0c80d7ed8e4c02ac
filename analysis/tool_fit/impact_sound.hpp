// One impact on a steel: cut out of a recording, or played by a tool model.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rigsound/tool_model.hpp"

namespace rigsound::analysis {

constexpr std::size_t kBeforeImpact = 48;  ///< samples at kAnalysisRate kept before the onset

struct RecordedImpact {
  std::size_t onset = 0;       ///< sample of the recording
  std::vector<double> before;  ///< what the recording has before the onset, at most half a second
  std::vector<double> sound;   ///< from kBeforeImpact before the onset to the next impact, at most one second
};

/// The strongest impact of `x` (at kAnalysisRate), or none when nothing stands out. Thread: OFF.
std::optional<RecordedImpact> strongest_impact(const std::vector<float>& x);

/// `samples` of `model` at kAnalysisRate with one impact after kBeforeImpact samples, without bounces or
/// random variation. Thread: OFF.
std::vector<double> one_impact(const ToolModel& model, std::size_t samples);

}  // namespace rigsound::analysis
