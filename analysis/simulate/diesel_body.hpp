// The simulated diesel's body: twelve resonances side by side.
#pragma once

#include <vector>

namespace rigsound::analysis {

/// `x` through the body, kAnalysisRate, from rest.
std::vector<double> through_body(const std::vector<double>& x);

/// The body's true magnitude response, dB. Thread: OFF.
double simulated_body_db(double f_hz);

}  // namespace rigsound::analysis
