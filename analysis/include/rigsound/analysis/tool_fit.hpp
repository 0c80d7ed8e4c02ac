// From the recorded sound of an impact to a steel that sounds like it.
#pragma once

#include <vector>

#include "rigsound/analysis/progress.hpp"
#include "rigsound/analysis/recording.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::analysis {

struct ToolFitOptions {
  double length_m = 0, diameter_m = 0;  ///< 0: estimated from the modes, which must then be clear
};

/// One third-octave band of the impact, dB over the loudest band of the recording.
struct FittedBand {
  double centre_hz = 0, recorded_db = 0, model_db = 0;
};

struct ToolFit {
  ToolModel model;                   ///< decays, shelves, high-pass, equaliser, mix and pulse width fitted
  bool estimated = false;            ///< length or diameter came from the modes
  int matched_modes = 0;             ///< recorded partials that lie on a mode of the steel
  double onset_s = 0, length_s = 0;  ///< the impact that was fitted
  std::vector<FittedBand> bands;     ///< 125 Hz...16 kHz, those within 40 dB of the loudest
  double mean_error_db = 0, worst_error_db = 0;
};

/// Fits to the strongest impact in `recording`. Throws InputError when there is no impact, or when length or
/// diameter is to be estimated and the modes are not clear; `file` is named in the message. Thread: OFF.
ToolFit fit_tool(const Recording& recording, const std::string& file, const ToolFitOptions& options,
                 const Progress& progress = {});

}  // namespace rigsound::analysis
