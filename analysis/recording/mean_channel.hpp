// Sound of any number of channels as one.
#pragma once

#include <sndfile.h>

#include <cstddef>

namespace rigsound::analysis {

/// The next `count` frames, each the mean of its channels; how many there were. Block by block: a long
/// recording is never in memory with all its channels. Thread: OFF.
std::size_t read_mean(SNDFILE* sound, int channels, float* to, std::size_t count);

}  // namespace rigsound::analysis
