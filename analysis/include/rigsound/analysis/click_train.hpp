// Where the clicks of a recording lie, how strong they are, and the envelope they share.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// The attack/decay envelope of one click (drilling paper, eq. 5 and 6), in samples at 48 kHz.
struct ClickEnvelope {
  double attack_samples = 0;  ///< N_a: attack
  double attack_bend = 0;     ///< alpha_a: attack bend, 1/sample
  double decay = 0;           ///< alpha_d: decay, 1/sample
};

struct ClickTrain {
  std::vector<int> P;        ///< onsets, samples, ascending
  std::vector<double> beta;  ///< amplitude of each click in the whitened signal, scaled so that
                             ///< the train's energy is the drilling's (full scale 1); same length as P
  ClickEnvelope envelope;
  double mean_gap_samples = 0;  ///< period the detector settled on, samples
};

}  // namespace rigsound::analysis
