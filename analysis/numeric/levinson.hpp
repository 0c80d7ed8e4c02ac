// Linear prediction from an autocorrelation.
#pragma once

#include <Eigen/Core>

namespace rigsound::analysis {

/// The prediction-error filter A = (1, a_1 … a_p) that solves the Toeplitz normal equations
/// sum_j a_j r(|i-j|) = -r(i), i = 1 … p, for the autocorrelation r(0 … p), by Levinson-Durbin.
/// Minimum phase for a positive definite r. Thread: OFF.
Eigen::ArrayXd levinson(const Eigen::ArrayXd& r);

}  // namespace rigsound::analysis
