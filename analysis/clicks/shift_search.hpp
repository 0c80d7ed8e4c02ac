// Step 5, click by click: the onset of largest likelihood.
#pragma once

#include "clicks/variance_model.hpp"

namespace rigsound::analysis {

struct ShiftRange {
  long reach = 0;  ///< blocks to either side
  long step = 1;   ///< blocks
};

/// Change of the divergence when click i moves by each of -reach, -reach + step, … : computed block by block
/// where its attack may come to lie; its tail only changes by a factor, so the tail's part is interpolated
/// between five shifts. `v`: the current variance; `q` must be clipped; `a2`: sampled_power() of the shape.
/// Thread: OFF.
Eigen::ArrayXd shift_costs(const Eigen::ArrayXd& q, const Eigen::ArrayXd& v, const EnvelopePower& shape,
                           const Eigen::ArrayXd& a2, long onset, double power, const ShiftRange& range);

/// Moves every click to its best shift, loudest first, the variance following each move; the clicks end in
/// order. Thread: OFF.
void shift_clicks(const Eigen::ArrayXd& q, const EnvelopePower& shape, const ShiftRange& range,
                  ModelClicks& clicks);

/// a^2 as blocks until it has fallen by 50 dB. Thread: OFF.
Eigen::ArrayXd sampled_power(const EnvelopePower& shape);

}  // namespace rigsound::analysis
