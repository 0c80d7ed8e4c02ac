// Does the waveform of one click come again with the next?
#pragma once

#include <Eigen/Core>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// Median over neighbouring clicks of the largest correlation, -1...1, between the recording from a click on
/// and that from the next one on, within 1 ms of it; over 0.8 of a gap, 30 ms at most. Near 1 for what sounds
/// on between its pulses: a voice, a tone, an engine, whose orders carry from one firing to the next; and for
/// stick-slip, which excites the same modes the same way. Rock breaks anew with every impact: below 0.85 even
/// for a drill that rings clean. `x` at kAnalysisRate; 0 from fewer than three pairs. Thread: OFF.
double repetition(const Eigen::Ref<const Eigen::ArrayXf>& x, const ClickTrain& clicks);

}  // namespace rigsound::analysis
