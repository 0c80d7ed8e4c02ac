// The model behind the verdict "drilling or not": how much each figure that speaks against drilling counts.
#pragma once

#include <array>
#include <cstddef>

namespace rigsound::analysis {

constexpr std::size_t kObjections = 9;

/// ln(p / (1 - p)) = kBias - sum of coefficient times weight (clicks/drilling_test), a weight being at most
/// kMostWeight. tests/bench/verdict trains them on the weights that --dump writes.
constexpr double kMostWeight = 3;

// made by tests/bench/verdict
constexpr double kBias = 3.71;
constexpr std::array<double, kObjections> kCoefficients = {
    0.58,  // rate
    3.67,  // swell
    3.67,  // surplus
    2.05,  // pulses
    5.31,  // dispersion
    5.19,  // rise
    7.23,  // rhythm
    3.06,  // irregularity
    1.55,  // unexplained
};
// end

}  // namespace rigsound::analysis
