// Is there a percussive drill in this recording at all?
#pragma once

#include <string>

#include "clicks/selection.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// Why the selected clicks are no drilling, or nothing when they may be. Thread: OFF.
std::string no_drilling_reason(const Selection& selection);

/// The same for clicks found another way: each is given the largest statistic nearer to it than to its
/// neighbours. Thread: OFF.
std::string no_drilling_reason(const Candidates& candidates, const ClickTrain& train);

}  // namespace rigsound::analysis
