// Several machines in a recording: which of a segment's trains is whose.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// What the segments of a recording hold of one machine, in the order of time.
using MachineResults = std::vector<ChainResult>;

/// From each segment's machines (analyse_clip()) those of the recording, the loudest first. Trains of one
/// machine keep its rate; where a segment has none of it, it is silent there and all is background. Thread:
/// OFF.
std::vector<MachineResults> by_machine(std::vector<std::vector<ChainResult>> segments);

/// Of one machine whose drilling was found in a recording of `length` samples. Thread: OFF.
Machine machine_figures(const SegmentedResult& machine, std::size_t length);

/// Clicks and verdicts of all machines in one, each click with its machine; powers and envelope are the first
/// one's. Thread: OFF.
ChainResult together(const std::vector<SegmentedResult>& machines);

}  // namespace rigsound::analysis
