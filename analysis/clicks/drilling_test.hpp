// Is there a percussive drill in this recording at all?
#pragma once

#include <string>

#include "clicks/selection.hpp"

namespace rigsound::analysis {

/// Why the selected clicks are no drilling, or nothing when they may be. Thread: OFF.
std::string no_drilling_reason(const Selection& selection);

}  // namespace rigsound::analysis
