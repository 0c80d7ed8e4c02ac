// Step 5, the envelope: maximum likelihood over the shape all clicks share.
#pragma once

#include "clicks/variance_model.hpp"

namespace rigsound::analysis {

struct EnvelopeFitOptions {
  int block = 8;         ///< samples
  int evaluations = 60;  ///< of the likelihood
  int sweeps = 3;        ///< power updates inside each evaluation
};

/// Minimises the model's cost plus weak priors over (N_a, alpha_a, alpha_d, a shift common to all clicks) by
/// the simplex method; every evaluation lets the powers follow. Leaves envelope, onsets, powers and floor at
/// the optimum. q: power of blocks; T_0 in samples. Thread: OFF.
void fit_envelope(const Eigen::ArrayXd& q, double T_0, const EnvelopeFitOptions& options,
                  ClickEnvelope& envelope, ModelClicks& clicks);

/// Where the fit starts: N_a = 0.03 T_0, no bend, alpha_d from the slope of the click-synchronous mean power.
/// `onset` in blocks of `block` samples. Thread: OFF.
ClickEnvelope first_envelope(const Eigen::ArrayXd& q, const std::vector<long>& onset, double T_0, int block);

}  // namespace rigsound::analysis
