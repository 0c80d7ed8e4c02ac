// Every click that could go into a bank, with what the choice needs to know about it.
#pragma once

#include <vector>

#include "bank/segment.hpp"

namespace rigsound::analysis {

struct ClickCandidate {
  std::size_t segment = 0, click = 0;
  double norm = 0;        ///< L2 norm in the recording's units
  double gap = 0;         ///< to the next click, periods
  double prominence = 0;  ///< beta over the louder neighbour
};

/// The clicks that count in each segment, in the order of time, but none without a neighbour on both sides
/// and none cut off by the segment's end (60 % of the length must be there). Thread: OFF.
std::vector<ClickCandidate> click_candidates(const Segments& segments);

}  // namespace rigsound::analysis
