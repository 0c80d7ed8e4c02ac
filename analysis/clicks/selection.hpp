// Step 4: the chain of candidates that a percussive drill would have made.
#pragma once

#include <vector>

#include "clicks/best_chain.hpp"
#include "clicks/candidates.hpp"
#include "clicks/period.hpp"

namespace rigsound::analysis {

struct Selection {
  std::vector<int> block;      ///< of the clicks, ascending
  double mean_gap_blocks = 0;  ///< median gap, blocks
  double total = 0;            ///< of the chain
  double surplus = 0;          ///< of the total, over what the same candidates give at random times
};

/// Tries every period hypothesis within `range` and keeps the chain whose total exceeds most what the same
/// candidates would give at random times: a short period finds a candidate for every impact by chance.
/// Thread: OFF.
Selection select_clicks(const Candidates& candidates, const RateRange& range);

/// The chain of one period, blocks. Thread: OFF.
Selection select_at_period(const Candidates& candidates, double T_0);

}  // namespace rigsound::analysis
