// Sound as FLAC in memory.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

/// A FLAC file of 16 bits, `mono` at `rate` Hz (full scale 1, clipped). Errors: std::runtime_error. Thread:
/// OFF.
std::string flac_bytes(const std::vector<float>& mono, int rate);

}  // namespace rigsound::analysis
