// The drilling paper's smooth energy, eq. 4.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

/// Symmetric Hann window of `length` samples without its zeros, squared.
Eigen::ArrayXd squared_hann(int length);

/// e_n = sum_j y_{n+j}^2 w_j^2 at n = 0, hop, 2 hop …; `squared_window` covers j = -before … ; zeros outside
/// y. Thread: OFF.
Eigen::ArrayXd integrated_energy(const Eigen::ArrayXd& y, const Eigen::ArrayXd& squared_window, long before,
                                 long hop);

}  // namespace rigsound::analysis
