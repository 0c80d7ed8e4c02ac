// What endless synthesis of a bank sounds like on average, from the spectra of its clicks.
#pragma once

#include <Eigen/Core>

#include "bank/third_octave.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

/// Spectra of a_i a_j over t_j - t_i of impacts that the engine plays, of pairs with the same click and of
/// the others; the squares a_i^2, with which they begin, sum to one. They depend on nothing but the bank's
/// statistics and how many clicks it has, and not on its level.
struct ImpactPairs {
  /// Errors: InputError when the bank cannot be played. Thread: OFF.
  explicit ImpactPairs(const ClickBank& bank);

  Eigen::ArrayXd of_same, of_other;  ///< real
};

/// The expected sum over all pairs of impacts of a_i a_j G_i conj(G_j) exp(i w (t_j - t_i)): what clicks a
/// pair has depends on nothing but whether they are the same. The impacts' number and mean power are those of
/// the bank's statistics. Thread: OFF.
class EndlessSpectrum {
 public:
  EndlessSpectrum(const ImpactPairs& pairs, const ClickBank& bank);

  /// What third_octave_levels() of a long synthesis tends to.
  BandLevels third_octaves() const;

  double mean_square() const;

 private:
  Eigen::ArrayXd power_;
};

}  // namespace rigsound::analysis
