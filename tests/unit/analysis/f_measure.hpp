// How well found onsets are the true ones.
#pragma once

#include <cstdlib>
#include <vector>

namespace rigsound::analysis {

/// F measure: a true onset is matched by one found within `tolerance` samples, 2 ms at 48 kHz. Both ascend.
template <class Onset>
double f_measure(const std::vector<int>& found, const std::vector<Onset>& truth, long tolerance = 96) {
  std::size_t i = 0, j = 0, matched = 0;
  while (i < found.size() && j < truth.size()) {
    const long apart = found[i] - truth[j];
    if (std::labs(apart) <= tolerance)
      ++matched, ++i, ++j;
    else
      apart < 0 ? ++i : ++j;
  }
  return 2.0 * double(matched) / double(found.size() + truth.size());
}

}  // namespace rigsound::analysis
