// Step 7: the chosen clicks, cut out of their neighbours.
#pragma once

#include "bank/candidates.hpp"

namespace rigsound::analysis {

/// The clicks `chosen` of `candidates`, masked in the drilling itself. Thread: OFF.
std::vector<std::vector<float>> extract_masked(const Segments& segments,
                                               const std::vector<ClickCandidate>& candidates,
                                               const std::vector<std::size_t>& chosen);

/// Section 3.6 of the paper: the clicks `chosen` of `candidates`: the signal whitened by LPC of order 1024,
/// masked, filtered by 1/A. Thread: OFF.
std::vector<std::vector<float>> extract_whitened(const Segments& segments,
                                                 const std::vector<ClickCandidate>& candidates,
                                                 const std::vector<std::size_t>& chosen);

}  // namespace rigsound::analysis
