// The modes of a steel as a picture: wanted, reached, and how long they ring.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rigsound/analysis/tool_fit.hpp"
#include "rigsound/tool_design.hpp"

namespace rigsound::analysis {

/// An SVG page of two panels over frequency (logarithmic): error of each mode in cents, and its T60, with the
/// bounds of what was recorded, if it was (ToolFit::bands). Thread: OFF.
std::string tool_plot_svg(std::string_view title, const std::vector<TunedMode>& modes,
                          const std::vector<FittedBand>& recorded = {});

}  // namespace rigsound::analysis
