// A picture of a learned background: what was recorded and what the model plays.
#pragma once

#include <filesystem>
#include <vector>

#include "rigsound/analysis/diesel.hpp"

namespace rigsound::analysis {

/// SVG of at most 0.2 MB, one row a point of the model, at most twelve spread over its speeds: spectrum with
/// the orders marked (left), mean power over the engine cycle in octaves (right); recorded and modelled.
/// Without takes only the model. Errors: DeviceError. Thread: OFF.
void write_background_plot(const std::filesystem::path& file, const std::vector<DieselTake>& takes,
                           const DieselModel& model);

}  // namespace rigsound::analysis
