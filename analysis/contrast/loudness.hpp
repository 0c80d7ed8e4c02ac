// Loudness of steady sounds by Zwicker's method: ISO 532-1:2017, section 5, frontal free field.
#pragma once

#include <array>
#include <vector>

namespace rigsound::analysis {

constexpr int kLoudnessBands = 28;
using LoudnessBands = std::array<double, kLoudnessBands>;  ///< third octaves of 25 Hz...12.5 kHz, dB SPL

/// Levels of `x` (kAnalysisRate) in the standard's bands; a sine of full scale has `full_scale_db_spl`. The
/// filters are third-order Butterworth band-passes, applied to the mean power spectrum. Thread: OFF.
LoudnessBands loudness_bands(const std::vector<float>& x, double full_scale_db_spl);

/// N, sone: 1 for a tone of 1 kHz at 40 dB SPL, 2 for what is twice as loud. Thread: OFF.
double loudness_sone(const LoudnessBands& levels);

/// L_N, phon: sound pressure level of a 1 kHz tone that is as loud, at least 3. Thread: OFF.
double loudness_level_phon(double sone);

}  // namespace rigsound::analysis
