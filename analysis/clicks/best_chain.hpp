// The chain of times that a percussive drill would have made, by dynamic programming.
#pragma once

#include <vector>

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

/// Of no best chain is the total less: that of the highest candidate alone. `score`: at least one. Thread:
/// OFF.
double least_total(const std::vector<double>& score);

}  // namespace rigsound::analysis
