// What endless synthesis of a bank sounds like on average, from the spectra of its clicks.
#pragma once

#include <Eigen/Core>

#include "bank/third_octave.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// The expected sum over all pairs of impacts of a_i a_j G_i conj(G_j) exp(i w (t_j - t_i)): what clicks a
/// pair has depends on nothing but whether they are the same. Times, amplitudes and sameness are those of
/// impacts that the engine plays, their number and mean power those of the bank's statistics. Errors:
/// InputError when the bank cannot be played. Thread: OFF.
class EndlessSpectrum {
 public:
  explicit EndlessSpectrum(const ClickBank& bank);

  /// What third_octave_levels() of a long synthesis tends to.
  BandLevels third_octaves() const;

  double mean_square() const;

 private:
  Eigen::ArrayXd power_;
};

}  // namespace rigsound::analysis
