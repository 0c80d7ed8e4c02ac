// What the bank is built from: the analysed segments of one labelled part.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// Segments of one part in time order, all with clicks. Amplitudes are comparable between them only as L2
/// norms in `drilling`: beta is relative to each segment's own whitening.
using Segments = std::vector<ChainResult>;

}  // namespace rigsound::analysis
