// The model behind the verdict "drilling or not": how much each figure that speaks against drilling counts.
#pragma once

#include <array>
#include <cstddef>

namespace rigsound::analysis {

constexpr std::size_t kObjections = 10;

/// ln(p / (1 - p)) = kBias - sum of coefficient times weight (clicks/drilling_test), a weight being at most
/// kMostWeight. tests/bench/verdict trains them on the weights that --dump writes.
constexpr double kMostWeight = 3;

// made by tests/bench/verdict
constexpr double kBias = 4.23;
constexpr std::array<double, kObjections> kCoefficients = {
    1.06,  // rate
    3.23,  // swell
    5.02,  // surplus
    2.10,  // pulses
    5.11,  // dispersion
    3.62,  // rise
    3.19,  // rhythm
    3.11,  // irregularity
    3.22,  // unexplained
    5.63,  // repetition
};
// end

}  // namespace rigsound::analysis
