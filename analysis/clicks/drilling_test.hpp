// The verdict on a clip: percussive drilling or not.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "clicks/click_likeness.hpp"
#include "clicks/drilling_model.hpp"
#include "clicks/selection.hpp"
#include "rigsound/analysis/click_train.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

constexpr std::size_t kFewestDrillingClicks = 6;  ///< less is no drilling

/// What the clicks found in a recording look like.
struct DrillingEvidence {
  ClickTrain clicks;
  double total = 0;            ///< of the selected chain
  double surplus = 0;          ///< of that total over chance
  double fast_total = 0;       ///< of the best chain faster than any drill
  double irregularity = 0;     ///< median of |ln(gap / median gap)|
  double jitter = 0;           ///< the same against the gaps around each: a rate may glide
  double strength_rhythm = 0;  ///< of the clicks, see strength_rhythm()
  double repetition = 0;       ///< of the waveform, see repetition()
  ClickLikeness likeness;
  double background_alone = 0;  ///< divergence per cell that a slow background leaves
  double with_clicks = 0;       ///< divergence per cell with the click train's words
  double left_over = 0;         ///< the same of the bin that is left with more than a quarter of them
};

/// The probability that it is drilling: logistic in what its figures say against it. 0 for fewer than
/// kFewestFitted clicks. Noise has clicks no better than chance finds; a swell (a rotary drill, an idling
/// diesel) has no sharp rise; a voice or an instrument pulses faster than a drill or is not explained by one
/// click repeated; the notes and drums of music differ from one another, follow bars, keep no period or
/// sound beside others; a voice, an engine and stick-slip repeat their waveform.
/// Thread: OFF.
double drilling_probability(const DrillingEvidence& evidence);

/// The same of clicks whose envelope is only roughly fitted: whatever its attack, it says nothing against
/// drilling. Through the whitener of a blind split a low, slowly ringing click is a plateau in noise, whose
/// length the two rough rounds take for an attack. Thread: OFF.
double drilling_promise(const DrillingEvidence& evidence);

/// What each of its figures says against drilling: 0 where nine drills in ten are or better, 1 where it alone
/// is much. In the order of kCoefficients. Thread: OFF.
std::array<double, kObjections> objection_weights(const DrillingEvidence& evidence);

/// The figures that bear on it, in words. Thread: OFF.
std::string objections_to(const DrillingEvidence& evidence);

/// DrillingEvidence::irregularity of at least three clicks. Thread: OFF.
double irregularity(const ClickTrain& clicks);

/// DrillingEvidence::jitter of at least three clicks: against the median of nine gaps, its own in their
/// middle. Thread: OFF.
double jitter(const ClickTrain& clicks);

/// Total of the best chain at 130 to 400 Hz; 0 where that is the chain of `clicks` itself, of a drifter that
/// strikes nearly as fast. Thread: OFF.
double fast_total(const Candidates& candidates, const ClickTrain& clicks);

/// 1 in the frames of kChainStft from half a period before a click to two periods after, 0 elsewhere: pauses
/// say nothing about the clicks. Thread: OFF.
Eigen::ArrayXf frames_near_clicks(const ClickTrain& train, int frames);

}  // namespace rigsound::analysis
