// The attack/decay envelope of a click, as samples and as power on blocks.
#pragma once

#include <Eigen/Core>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// a_n of the drilling paper, eq. 5 and 6; 0 before n = 0, 1 at n = N_a. Thread: OFF.
double envelope(const ClickEnvelope& shape, double n);

/// Samples in which a straight line rises that is as steep as the attack at its steepest: N_a of a straight
/// attack, less of a bent one, which comes up at once or at last. Thread: OFF.
double rise_samples(const ClickEnvelope& shape);

/// a^2 averaged over blocks: a few blocks one by one, then a geometric tail without end.
struct EnvelopePower {
  Eigen::ArrayXd attack;  ///< blocks up to the one in which the peak lies
  double tail = 0;        ///< the block after them
  double decay = 0;       ///< from a block to the next, < 1
};

/// `block` in samples. Thread: OFF.
EnvelopePower envelope_power(const ClickEnvelope& shape, int block);

/// sum_n a_n^2. Thread: OFF.
double envelope_energy(const ClickEnvelope& shape);

}  // namespace rigsound::analysis
