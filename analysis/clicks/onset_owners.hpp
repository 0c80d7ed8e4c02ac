// Which of two machines struck each onset, by their rhythms alone.
#pragma once

#include <array>
#include <vector>

namespace rigsound::analysis {

struct GapFigures {
  double period;   ///< median gap, samples
  double scatter;  ///< robust standard deviation of the gaps, periods: 0.02 ... 0.2
};

/// Of ascending onsets, at least two. Thread: OFF.
GapFigures gap_figures(const std::vector<int>& onsets);

constexpr int kNobody = -1;

/// For each of the ascending onsets 0, 1 or kNobody: the division in which the gaps of both machines together
/// are likeliest, a gap of n periods being normal about n with sqrt(n) times the scatter. Impacts may be
/// missed and onsets belong to neither, both at a price. The best 32 divisions are followed from onset to
/// onset, a division being known by the last onset of each machine. Thread: OFF.
std::vector<int> owners(const std::vector<int>& onsets, const std::array<GapFigures, 2>& machines);

}  // namespace rigsound::analysis
