// What a bank is built from: the drilling segments of one labelled part.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// Segments of one part in time order. Amplitudes are comparable between them only as L2 norms in `drilling`:
/// beta follows each segment's own whitening.
using Segments = std::vector<DrillingSegment>;

/// Those with enough clicks of their own (three) to learn from. Thread: OFF.
Segments learnable(const Segments& segments);

/// Onsets of the clicks that count in `segment`, and the one behind them when the segment knows it: the lists
/// of all segments hold every gap once. Samples of the segment. Thread: OFF.
std::vector<int> own_onsets(const DrillingSegment& segment);

}  // namespace rigsound::analysis
