// Where a note is steady, and the phase of its fundamental.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

struct NotePitch {
  double f0 = 0;                 ///< Hz, median over the steady part
  std::size_t from = 0, to = 0;  ///< steady samples
  std::vector<double> theta;     ///< periods at every sample of the note; straight outside the steady part
};

/// Autocorrelation pitch every 5 ms, 60...1500 Hz; steady is the longest stretch within 3 % of the median.
/// Errors: InputError when none lasts 0.3 s. Thread: OFF.
NotePitch pitch_of(const std::string& source, const std::vector<double>& x);

}  // namespace rigsound::analysis
