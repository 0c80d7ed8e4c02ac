// Step 2: the filter that makes clicks stand out of their background.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

/// Order-192 minimum-phase FIR whose power response follows 1/D, D(f) = (N + 0.1 S)(S + N)/S: it whitens
/// where the drilling is loud and turns bins down where the background is. S, N: mean powers per bin of a
/// 512-point transform (257 each). Applied to the mixture, not to the denoised signal: whitening a denoised
/// signal would amplify its residue again. Thread: OFF.
Eigen::ArrayXd noise_aware_whitener(const Eigen::ArrayXd& S, const Eigen::ArrayXd& N);

/// Prediction-error filter of `order` from the signal's own autocorrelation (drilling paper, 3.1). Thread:
/// OFF.
Eigen::ArrayXd lpc_whitener(const std::vector<float>& x, int order);

/// y_n = sum_k A_k x_{n-k}, same length as x, scaled to RMS 1. Thread: OFF.
Eigen::ArrayXd whiten(const std::vector<float>& x, const Eigen::ArrayXd& A);

}  // namespace rigsound::analysis
