// The band in which clicks are heard at all.
#pragma once

#include <vector>

#include "rigsound/analysis/click_train.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

/// What the clicks of a train are measured over.
struct ClickFrames {
  std::vector<long> onset;  ///< frames of kChainStft; clicks too near to either end are left out
  long length = 0;          ///< frames from there on: the first 12 ms, or 0.4 T_0 if that is shorter
};

constexpr long kBeforeFrom = 3;  ///< frames before an onset up to where the window reaches the click

/// Of a spectrogram of `frames` frames. Thread: OFF.
ClickFrames click_frames(const ClickTrain& clicks, long frames);

/// Bins of kChainStft from 0 Hz up to the highest that holds something at nine clicks in ten. A codec short
/// of bits writes its highest bands now and then: what is missing there is no figure of the drill. All bins
/// where there are no clicks. Thread: OFF.
long heard_bins(const PowerSpectrogram& power, const ClickFrames& clicks);

}  // namespace rigsound::analysis
