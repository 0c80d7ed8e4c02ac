// Takes and models shared by the rows of the benchmark.
#pragma once

#include <string>
#include <vector>

#include "diesel/section.hpp"
#include "rigsound/analysis/diesel.hpp"
#include "simulate/diesel_recording.hpp"

namespace rigsound::bench {

/// A recording of the simulated diesel. Ramps bring their log, steady ones their mean.
analysis::DieselTake simulated_take(const std::vector<double>& rpm, unsigned seed);
analysis::DieselTake steady_take(double rpm, double seconds, unsigned seed);

/// The only section of a steady take.
analysis::Section section_of(const analysis::DieselTake& take);

}  // namespace rigsound::bench
