// Change of sample rate (libsamplerate's best sinc).
#pragma once

#include <vector>

namespace rigsound::analysis {

/// `x` at `from` Hz as a signal at `to` Hz: round(size * to / from) samples, time origin kept.
/// Errors: std::runtime_error when libsamplerate refuses the ratio. Thread: OFF.
std::vector<float> resample(const std::vector<float>& x, int from, int to);

}  // namespace rigsound::analysis
