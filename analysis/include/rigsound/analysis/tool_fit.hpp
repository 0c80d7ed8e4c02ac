// From the recorded sound of an impact to a steel that sounds like it.
#pragma once

#include <limits>
#include <vector>

#include "rigsound/analysis/recording.hpp"
#include "rigsound/progress.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::analysis {

struct ToolFitOptions {
  double length_m = 0, diameter_m = 0;  ///< 0: estimated from the modes, which must then be clear
};

/// T60 of a band as far as the recording tells it, 95 % bounds, s. What it does not hear fall by 10 dB above
/// the noise has a lower bound only.
struct DecayBounds {
  double t60_s = 0;  ///< the likeliest; 0: not told
  double low_s = 0, high_s = std::numeric_limits<double>::infinity();
  double heard_db = 0;  ///< of its fall, above the noise

  bool told() const { return t60_s > 0; }
};

/// One third-octave band of the impact, dB over the loudest band of the recording.
struct FittedBand {
  double centre_hz = 0, recorded_db = 0, model_db = 0;
  double recorded_low_db = 0, recorded_high_db = 0;  ///< 95 % bounds of the impact itself, without the noise
  DecayBounds decay;

  bool holds(double hz) const;  ///< whether hz lies in it
};

struct ToolFit {
  ToolModel model;                   ///< decays, shelves, high-pass, equaliser, mix and pulse width fitted
  bool estimated = false;            ///< length or diameter came from the modes
  int matched_modes = 0;             ///< recorded partials that lie on a mode of the steel
  double onset_s = 0, length_s = 0;  ///< the impact that was fitted
  std::vector<FittedBand> bands;  ///< 125 Hz...16 kHz, those within 40 dB of the loudest and over the noise
  double mean_error_db = 0, worst_error_db = 0;

  const FittedBand* band_at(double hz) const;  ///< nullptr where nothing was fitted
};

/// Fits to the strongest impact in `recording`; the search keeps its modes from ringing longer than the
/// recording bears out. Throws InputError when there is no impact, when fewer than three bands tell their
/// decay, or when length or diameter is to be estimated and the modes are not clear; `file` is named in the
/// message. Thread: OFF.
ToolFit fit_tool(const Recording& recording, const std::string& file, const ToolFitOptions& options,
                 const Progress& progress = {});

}  // namespace rigsound::analysis
