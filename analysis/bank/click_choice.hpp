// Which clicks stand for all of them.
#pragma once

#include <vector>

#include "bank/candidates.hpp"

namespace rigsound::analysis {

/// Indices into `candidates`, at most `count`. Among the best 60 % (20 000 at most) by room to the next click
/// and prominence, greedily the set whose mean spectrum is nearest to the mean over all clicks. Thread: OFF.
std::vector<std::size_t> choose_by_cover(const Segments& segments,
                                         const std::vector<ClickCandidate>& candidates, std::size_t count);

/// The paper's own two criteria (section 3.6): louder than both neighbours first, then the longest gap.
/// Thread: OFF.
std::vector<std::size_t> choose_by_room(const std::vector<ClickCandidate>& candidates, std::size_t count);

}  // namespace rigsound::analysis
