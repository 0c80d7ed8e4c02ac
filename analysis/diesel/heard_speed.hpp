// Which speed a diesel runs at, from its sound alone.
#pragma once

#include <vector>

namespace rigsound::analysis {

struct HeardSpeed {
  double rpm = 0;         ///< the likeliest of kSlowestDiesel_rpm...kFastestDiesel_rpm
  double confidence = 0;  ///< 0...1, against the next likeliest; 0: none stands out
  double next_rpm = 0;    ///< often half of it or a multiple
  double over_given = 0;  ///< 0...1, its confidence against the speed that a person gave
};

/// The cycle of 720 degrees whose orders from 12 to 300 Hz stand out of the floor between them; every order
/// counts against a cycle that has it in vain, so that twice the cycle, which has all of them and as many
/// more, loses. Autocorrelation cannot tell them. `x`: at kAnalysisRate, a steady speed within 0.2 %;
/// `given_rpm`: right within 3 %, 0: none. Thread: OFF.
HeardSpeed heard_speed(const std::vector<double>& x, double given_rpm = 0);

}  // namespace rigsound::analysis
