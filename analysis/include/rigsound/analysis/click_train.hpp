// Where the clicks of a recording lie, how strong they are, and the envelope they share.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// The attack/decay envelope of one click (drilling paper, eq. 5 and 6), in samples at 48 kHz.
struct ClickEnvelope {
  double N_a = 0;      ///< attack, samples
  double alpha_a = 0;  ///< attack bend, 1/sample
  double alpha_d = 0;  ///< decay, 1/sample
};

struct ClickTrain {
  std::vector<int> P;        ///< onsets, samples, ascending
  std::vector<double> beta;  ///< amplitude of each click as heard through the whitening, scaled so that
                             ///< the train's energy is the drilling's (full scale 1); same length as P
  ClickEnvelope envelope;
  double T_0 = 0;  ///< period the detector settled on, samples
};

}  // namespace rigsound::analysis
