// What the bank is built from: the analysed segments of one labelled part.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// Segments of one part in time order. Amplitudes are comparable between them only as L2 norms in `drilling`:
/// beta follows each segment's own whitening.
using Segments = std::vector<ChainResult>;

/// Enough clicks to learn from.
bool has_drilling(const ChainResult& segment);

/// Those of them that have drilling.
Segments with_drilling(const Segments& segments);

}  // namespace rigsound::analysis
