// Steps 1 to 6 on one clip of a few seconds.
#pragma once

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// The chain on a clip short enough to be stationary (up to about 4 s). Thread: OFF.
ChainResult analyse_clip(const std::vector<float>& mono, const ChainOptions& options);

}  // namespace rigsound::analysis
