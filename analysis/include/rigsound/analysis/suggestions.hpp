// Where a recording changes its rate, level or spectrum, as a first draft of its label track.
#pragma once

#include <vector>

#include "rigsound/analysis/sound_reader.hpp"
#include "rigsound/progress.hpp"

namespace rigsound::analysis {

struct SuggestedPart {
  double start_s = 0, end_s = 0;
  bool rate_changed = false, level_changed = false,
       spectrum_changed = false;  ///< at its start, against the part before
  double rhythmic = 0;            ///< share of its time with a steady rhythm of impacts
  double rate_hz = 0;             ///< median there; 0: none
  double level_db = 0;            ///< of all bands together, dB re full scale
  double confidence = 0;          ///< in its start: 1 less the penalty over the likelihood gained, 0...1
};

/// Parts that cover the recording without gaps (README, *Suggested parts*). Errors: whatever `progress`
/// throws. Thread: OFF.
std::vector<SuggestedPart> suggest_parts(SoundReader& sound, const Progress& progress = {});

}  // namespace rigsound::analysis
