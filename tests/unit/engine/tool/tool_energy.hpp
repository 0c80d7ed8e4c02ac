// Does a ringing bar ever gain energy?
#pragma once

#include "tool/bar_kernel.hpp"

namespace rigsound::tests {

/// Largest relative growth of the loops' energy from one sample to the next, without input, over `samples`
/// samples: stretches with reflections of +-1, with any between, and with every section's b and c redrawn at
/// every sample as well. Struck anew when the bar falls asleep.
double largest_energy_growth(const ToolDesign& design, dsp::LaneWidth width, int samples);

}  // namespace rigsound::tests
