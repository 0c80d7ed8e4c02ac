// What a clip's neighbours say about it: drilling does not stop where a clip hardly tells it.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// Decides which of the clips of a recording that nobody labelled drill, machines of each in `clips`, by all
/// their windows together (drilling_windows()): one that may drill does where drilling goes on into it. Its
/// clicks count from the first to the last window that does; those of the other clips are dropped. Where two
/// machines drill, a clip has decided for itself. Thread: OFF.
void decide_beside_neighbours(std::vector<std::vector<ChainResult>>& clips);

}  // namespace rigsound::analysis
