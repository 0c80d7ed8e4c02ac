// How loud the drilling was, band by band: what a bank has to sound like.
#pragma once

#include "bank/segment.hpp"
#include "bank/third_octave.hpp"

namespace rigsound::analysis {

/// Mean third-octave levels from the first to the last click of every segment. What the denoiser took from
/// the drilling (its model S against its output, 0...9 dB) is given back in bands above 200 Hz where S is
/// at most 10 dB below the background. Levels::kDenoisedOnly leaves the output as it is. Thread: OFF.
enum class Levels { kDenoisedOnly, kGivenBack };
BandLevels recorded_levels(const Segments& segments, Levels levels);

/// Modulation levels of the longest segment, from its first to its last click: a pause before the drilling is
/// no modulation of it. Thread: OFF.
BandLevels recorded_modulation(const Segments& segments);

/// Mean square of the denoised drilling while it goes on: from first to last click without the pauses.
/// Thread: OFF.
double drilling_power(const Segments& segments);

/// Power of the modelled drilling over that of the background, dB; +infinity when nothing was taken away.
/// Thread: OFF.
double signal_to_noise_db(const Segments& segments);

}  // namespace rigsound::analysis
