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
constexpr double kBias = 4.24;
constexpr std::array<double, kObjections> kCoefficients = {
    1.07,  // rate
    3.23,  // swell
    5.03,  // surplus
    2.10,  // pulses
    5.12,  // dispersion
    3.63,  // rise
    3.20,  // rhythm
    3.05,  // irregularity
    3.23,  // unexplained
    5.36,  // repetition
};
// end

}  // namespace rigsound::analysis
