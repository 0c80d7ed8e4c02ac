// How much a narrow band leaves of a signal's samples.
#pragma once

#include <Eigen/Core>

namespace rigsound::analysis {

/// Of how many independent samples a mean power of y is worth, over the samples it is taken of: 1 / sum r_k^2
/// over all lags k up to 1.3 ms either way, r the normalised autocorrelation at a sixteenth of the samples. 1
/// of white noise, about the bandwidth over half the sampling rate of a band. Thread: OFF.
double independent_share(const Eigen::ArrayXd& y);

}  // namespace rigsound::analysis
