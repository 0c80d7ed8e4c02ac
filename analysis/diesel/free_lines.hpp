// Narrow lines that no cycle repeats: a fan on its belt, a motor on the mains (A10).
#pragma once

#include <vector>

#include "diesel/section.hpp"
#include "rigsound/diesel_model.hpp"

namespace rigsound::analysis {

/// A section and what its mean cycle leaves of it, one value a sample.
struct SectionResidual {
  const Section* section = nullptr;
  const std::vector<double>* x = nullptr;
};

/// What a line keeps its distance to.
enum class Lock { kCrank, kTime };

/// A line, and where each section has it (orders or Hz, as the tone is locked).
struct FreeLine {
  DieselOscillator tone;
  std::vector<double> frequency;
};

/// Lines of most of the sections. A line is a subband half an order wide that prediction from its own first
/// half clears by more than 3 dB in the second, with twice as much power in its peak as beside it, off the
/// orders themselves. It is order-locked when it keeps its order from section to section, or is sharper over
/// crank angle than over time; where the speed is too steady to tell, it counts as locked. `N`: angle samples
/// a cycle, a power of two. Nothing is found in recordings with impacts, whose gates would make lines of
/// their own. Thread: OFF.
std::vector<FreeLine> free_lines(const std::vector<SectionResidual>& residuals, int N);

/// `x` without the line of `frequency`, whatever its level and phase do slower than 1 Hz. Thread: OFF.
std::vector<double> without_line(const Section& section, std::vector<double> x, double frequency, Lock lock);

}  // namespace rigsound::analysis
