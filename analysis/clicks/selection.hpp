// Step 4: the chain of candidates that a percussive drill would have made.
#pragma once

#include <vector>

#include "clicks/candidates.hpp"
#include "clicks/period.hpp"

namespace rigsound::analysis {

/// One way through the candidates.
struct Chain {
  std::vector<int> chosen;  ///< indices into the candidates, ascending
  double total = 0;         ///< scores less costs
};

/// What a gap of g periods costs: robust around 1, 2 … 4 (missed impacts), cheap around a half (a double
/// impact); infinite below 0.28 and above 4.5, where only a pause continues the chain. Thread: OFF.
double gap_cost(double g);

/// gap_cost() of every whole number of blocks that a gap of one period may have: chains ask for the same few
/// thousand over and over. Thread: OFF.
struct GapCosts {
  explicit GapCosts(double period);  ///< blocks

  double T_0;                  ///< blocks
  std::vector<double> of_gap;  ///< blocks 0, 1 ... up to the longest gap
};

/// The chain of largest total = sum of scores - gap costs - pauses - silent edges, by dynamic programming.
/// `time`: blocks, ascending; `length`: blocks of the whole signal. Thread: OFF.
Chain best_chain(const std::vector<int>& time, const std::vector<double>& score, const GapCosts& costs,
                 long length);

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
