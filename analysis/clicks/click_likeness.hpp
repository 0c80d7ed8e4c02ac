// Do the clicks resemble one another?
#pragma once

#include "clicks/heard_band.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

struct ClickLikeness {
  /// Mean Itakura-Saito divergence of the clicks' band powers from one spectrum with a gain a click over a
  /// steady background. The clicks of one tool keep to it; notes, syllables and a drum kit do not.
  double dispersion = 0;
  double rise = 0;    ///< mean of ln(power from a click on / power before it) over clicks and bands
  double rhythm = 0;  ///< of the band powers, see rhythm()
};

/// From the powers in 19 bands (below 250 Hz, and up to 16 kHz) that lie whole in the first `heard` bins
/// (heard_bins()), over the clicks' first milliseconds. `power` in frames of kChainStft. No figures
/// from fewer than two clicks. Thread: OFF.
ClickLikeness click_likeness(const PowerSpectrogram& power, const ClickFrames& clicks, long heard);

}  // namespace rigsound::analysis
