// Section 3.7 of the drilling paper, errata 14 and 15: how gaps and amplitudes are distributed.
#pragma once

#include <vector>

#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// One vector a segment; neighbours in a vector are neighbours in time.
template <class Value>
using Series = std::vector<std::vector<Value>>;

/// Sets T_0, sigma_T and r_T from the gaps within 0.6...1.5 of the median that are no rest of a doubled one,
/// p_miss and p_double from the others. `onsets` in samples, at least one segment with two of them. Thread:
/// OFF.
void set_gap_statistics(const Series<int>& onsets, ClickBank& bank);

/// Mean and standard deviation over all gaps, as printed (parentheses of erratum 15 added). Thread: OFF.
void set_plain_gap_statistics(const Series<int>& onsets, ClickBank& bank);

/// Sets B, sigma_B and r_B from the L2 norms of the clicks. Thread: OFF.
void set_amplitude_statistics(const Series<double>& norms, ClickBank& bank);

}  // namespace rigsound::analysis
