// How loud the drilling was, band by band: what a bank has to sound like.
#pragma once

#include "bank/segment.hpp"
#include "bank/third_octave.hpp"

namespace rigsound::analysis {

/// Mean third-octave levels of the denoised drilling from the first to the last click of every segment.
/// Thread: OFF.
BandLevels recorded_levels(const Segments& segments);

/// recorded_levels() with what the denoiser took from the drilling (its model S against its output, 0...9 dB)
/// given back in bands above 200 Hz where S is at most 10 dB below the background. Thread: OFF.
BandLevels given_back(const Segments& segments, BandLevels recorded);

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
