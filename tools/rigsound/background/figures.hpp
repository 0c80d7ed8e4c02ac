// What was learned of a diesel, in figures.
#pragma once

#include <string>

#include "rigsound/analysis/diesel.hpp"

namespace rigsound::tools {

/// One JSON object, or one line of words; `sound_set` is where the model went.
std::string figures_json(const analysis::LearnedDiesel& learned, const std::string& sound_set);
std::string figures_line(const analysis::LearnedDiesel& learned);

}  // namespace rigsound::tools
