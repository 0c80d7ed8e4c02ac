// Gaps and amplitudes of the clicks of a part, as they are shown.
#pragma once

#include <vector>

#include "bank/segment.hpp"

namespace rigsound::analysis {

std::vector<double> gaps_ms(const Segments& segments);               ///< Thread: OFF
std::vector<double> amplitudes_over_mean(const Segments& segments);  ///< L2 norms; Thread: OFF

}  // namespace rigsound::analysis
