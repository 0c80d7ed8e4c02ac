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
constexpr double kBias = 4.61;
constexpr std::array<double, kObjections> kCoefficients = {
    1.35,  // rate
    3.16,  // swell
    5.62,  // surplus
    2.10,  // pulses
    7.62,  // dispersion
    3.01,  // rise
    3.20,  // rhythm
    3.73,  // irregularity
    3.44,  // unexplained
    5.57,  // repetition
};
// end

}  // namespace rigsound::analysis
