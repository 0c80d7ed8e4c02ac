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
constexpr double kBias = 4.96;
constexpr std::array<double, kObjections> kCoefficients = {
    1.08,  // rate
    4.08,  // swell
    5.31,  // surplus
    2.10,  // pulses
    5.39,  // dispersion
    2.61,  // rise
    3.22,  // rhythm
    4.73,  // irregularity
    2.10,  // unexplained
    4.80,  // repetition
};
// end

}  // namespace rigsound::analysis
