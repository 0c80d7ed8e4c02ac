// Step 5 as a whole: from selected candidates to onsets, amplitudes and envelope.
#pragma once

#include <Eigen/Core>

#include "clicks/selection.hpp"
#include "clicks/variance_model.hpp"
#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

constexpr std::size_t kFewestFitted = 4;  ///< clicks an envelope can be fitted to

constexpr int kCoarse = 8;  ///< samples a block, before the fit is fine

enum class FitEffort {
  kRough,  ///< two rounds on blocks of 8 samples: enough to explain a spectrogram by
  kFull
};

/// Maximum-likelihood clicks of the whitened signal y (RMS 1): three rounds on blocks of 8 samples (envelope,
/// shifts, removals, additions), one on 2 samples, then shifts at full rate. `selection` must hold at least
/// kFewestFitted clicks. `others`: variance of what else is known to strike, a sample; empty: nothing.
/// Thread: OFF.
ClickTrain fit_clicks(const Eigen::ArrayXd& y, const Candidates& candidates, const Selection& selection,
                      FitEffort effort, const Eigen::ArrayXd& others = {});

/// Part of a round on blocks of kCoarse samples: the envelope in so many iterations, shifts of up to `reach`
/// blocks, powers. The power of the envelope. Thread: OFF.
EnvelopePower fit_coarsely(const Eigen::ArrayXd& q, double T_0, int iterations, long reach,
                           ClickEnvelope& envelope, ModelClicks& clicks);

/// The last part of fit_clicks(): from clicks on blocks of kCoarse and their envelope to full rate. Thread:
/// OFF.
ClickTrain fit_finely(const Eigen::ArrayXd& y, double T_0, ClickEnvelope envelope, ModelClicks clicks,
                      const Eigen::ArrayXd& others);

/// The train with envelope and amplitudes fitted anew at full rate; the onsets, ascending, move only
/// together. `others`: see fit_clicks(). Thread: OFF.
ClickTrain refitted(const Eigen::ArrayXd& y, const ClickTrain& train, const Eigen::ArrayXd& others = {});

}  // namespace rigsound::analysis
