// Step 7: the chosen clicks, cut out of their neighbours.
#pragma once

#include <functional>

#include "bank/candidates.hpp"

namespace rigsound::analysis {

/// Calls `listener` with each of the `wanted` of `candidates` and its sound, masked in the drilling itself,
/// in the order of time: one segment is in memory. Thread: OFF.
void for_each_click(const Segments& segments, const std::vector<ClickCandidate>& candidates,
                    std::vector<std::size_t> wanted,
                    const std::function<void(std::size_t candidate, std::vector<float> click)>& listener);

/// The same, in the order of `chosen`. Thread: OFF.
std::vector<std::vector<float>> extract_masked(const Segments& segments,
                                               const std::vector<ClickCandidate>& candidates,
                                               const std::vector<std::size_t>& chosen);

/// Section 3.6 of the paper: the clicks `chosen` of `candidates`: the signal whitened by LPC of order 1024,
/// masked, filtered by 1/A. Thread: OFF.
std::vector<std::vector<float>> extract_whitened(const Segments& segments,
                                                 const std::vector<ClickCandidate>& candidates,
                                                 const std::vector<std::size_t>& chosen);

}  // namespace rigsound::analysis
