// A bank beside the recording it came from: what report.html draws, as numbers.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/chain.hpp"
#include "rigsound/analysis/curve.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// Share of the values in each bin, and what the engine draws from in the same measure.
struct Histogram {
  std::vector<double> edges, share;  ///< one edge more than shares
  Curve engine;
};

/// Third-octave levels (Hz, dB re full scale) and those of the envelope's modulation (Hz, dB re its mean).
struct SoundSpectra {
  Curve third_octaves, modulation;
};

/// One part of a recording, at kAnalysisRate.
struct RecordedSide {
  std::vector<float> recorded, denoised;  ///< of equal length
  SoundSpectra of_recorded, of_denoised;  ///< the denoised while it drills
  Curve target;                           ///< third-octave levels that the bank aims at
  std::vector<double> gaps_ms;            ///< between clicks
  std::vector<double> amplitudes;         ///< of clicks, over their mean
};

/// How the part of a bank was analysed, of Provenance::settings. Thread: any.
ChainOptions chain_of(const std::string& settings);

/// Repeats the analysis of a part. Errors: InputError naming `part` when there is no drilling in it. Thread:
/// OFF.
RecordedSide recorded_side(std::vector<float> recorded, const ChainOptions& chain, const std::string& part);

SoundSpectra spectra_of(const std::vector<float>& sound);  ///< Thread: OFF

/// Of values, at least one. Thread: OFF.
Histogram gap_histogram(const std::vector<double>& gaps_ms, const ClickBank& bank);
Histogram amplitude_histogram(const std::vector<double>& amplitudes, const ClickBank& bank);

}  // namespace rigsound::analysis
