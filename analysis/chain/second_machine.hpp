// A second machine that strikes in the same clip at a rate of its own.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "chain/click_search.hpp"
#include "denoise/factors.hpp"
#include "denoise/word_fit.hpp"
#include "rigsound/analysis/click_train.hpp"
#include "spectrum/power_spectrogram.hpp"

namespace rigsound::analysis {

/// One of two machines: what is found of it through its own whitener, the other one known.
struct FoundMachine {
  ClickSearch found;
  ClickTrain clicks;
};

struct TwoMachines {
  std::array<FoundMachine, 2> machine;  ///< the first one first
  Factors factors;                      ///< of step 6 with both
};

/// Looks for another chain of impacts in what `first` leaves of y: x whitened for the search before step 6.
/// It must be clear over chance and keep no phase with the first one, as echoes and double impacts do. Both
/// are then found anew, each with the other's variance known and in the bands in which it is the louder one.
/// Nothing where there is no second. Thread: OFF.
std::optional<TwoMachines> find_second_machine(const std::vector<float>& x, const Eigen::ArrayXd& y,
                                               const WordFit& clip, const ClickTrain& first);

/// The order, 1 to 4, at which the onsets of `other` keep their phase in the gaps of `train` best: the length
/// of the mean of exp(2 pi i h phase), 0 (no relation) ... 1 (locked). Thread: OFF.
double phase_locking(const ClickTrain& train, const ClickTrain& other);

/// The recording as if the machine whose words come first (drilling_of_train()) and the background were all.
/// Thread: OFF.
PowerSpectrogram without_other_machine(const PowerSpectrogram& power, const Factors& own);

/// Of factors of two machines those of the first and of the background. Thread: OFF.
Factors without_other_words(const Factors& own);

}  // namespace rigsound::analysis
