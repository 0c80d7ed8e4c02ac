// One blow cut out of a recording.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rigsound::analysis {

constexpr std::size_t kBeforeBlow = 48;  ///< samples at kAnalysisRate kept before the onset

struct Blow {
  std::size_t onset = 0;      ///< sample of the recording
  std::vector<double> sound;  ///< from kBeforeBlow before the onset to the next blow, at most one second
};

/// The strongest blow of `x` (at kAnalysisRate), or none when nothing stands out. Thread: OFF.
std::optional<Blow> strongest_blow(const std::vector<float>& x);

}  // namespace rigsound::analysis
