// Step 3: where the power of the whitened signal may have stepped up.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rigsound::analysis {

constexpr int kCandidateBlock = 16;  ///< samples

struct Candidates {
  Eigen::ArrayXd z;        ///< detection statistic of every block
  std::vector<int> block;  ///< peaks of z, ascending
  bool narrow = false;     ///< the signal's band: few of its samples are independent
};

/// Mean of each block of `block` samples of x; a remainder is left out. Thread: OFF.
Eigen::ArrayXd block_mean(const Eigen::ArrayXd& x, int block);

/// Mean power of each block of `block` samples of y; a remainder is left out. Thread: OFF.
Eigen::ArrayXd block_power(const Eigen::ArrayXd& y, int block);

/// Generalised likelihood ratio of an upward step in variance before block t, `forward` and `backward` blocks
/// of `samples` independent samples: z = sqrt(2 L), L = B/2 (n_f ln(v/v_f) + n_b ln(v/v_b)) with v_f, v_b, v
/// the mean powers after, before and around; 0 when v_f <= v_b. Thread: OFF.
double step_statistic(const Eigen::ArrayXd& cumulative, long t, long forward, long backward, int samples);

/// The statistic with windows of (2, 3) and (4, 4) ms, in a narrow band also of (8, 8) ms, the largest of
/// them, and its peaks of at least 1.5, 1 ms apart. Thread: OFF.
Candidates find_candidates(const Eigen::ArrayXd& y);

/// Those of blocks [first, last), counted from `first` on. Thread: OFF.
Candidates candidates_between(const Candidates& candidates, long first, long last);

/// Local maxima of `z` of at least `height`, `distance` apart: of two closer ones the lower goes. Thread:
/// OFF.
std::vector<int> peaks(const Eigen::ArrayXd& z, double height, int distance);

}  // namespace rigsound::analysis
