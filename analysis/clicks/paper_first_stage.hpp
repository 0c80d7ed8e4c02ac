// Section 3.2 of the drilling paper: first detection and first envelope.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// A peak of the integrated energy and the minima around it, samples.
struct EnergyPeak {
  long P_l = 0, P_p = 0, P_r = 0;
};

struct FirstStage {
  std::vector<EnergyPeak> peaks;
  ClickEnvelope envelope;
};

/// Peaks of e_n (Hann, 1023 samples) and the envelope through the points of sqrt(e'_n) (Hann, 511 samples):
/// N_a the median of P_p - P_l, alpha_d the mean of the slopes, alpha_a = (2/N_a) ln(r/(1-r)), r =
/// nu(P_m)/nu(P_p), the median: with P_m the middle of the attack, eq. 5 can be solved without a search. y:
/// whitened signal, RMS 1. Thread: OFF.
FirstStage paper_first_stage(const Eigen::ArrayXd& y);

}  // namespace rigsound::analysis
