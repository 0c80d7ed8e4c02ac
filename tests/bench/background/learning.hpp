// Takes and models shared by the rows of the benchmark.
#pragma once

#include <string>
#include <vector>

#include "background_model/section.hpp"
#include "rigsound/analysis/background.hpp"
#include "simulate/engine_recording.hpp"

namespace rigsound::bench {

/// A recording of the simulated diesel. Ramps bring their log, steady ones their mean.
analysis::EngineTake simulated_take(const std::vector<double>& rpm, unsigned seed);
analysis::EngineTake steady_take(double rpm, double seconds, unsigned seed);

/// The only section of a steady take.
analysis::Section section_of(const analysis::EngineTake& take);

}  // namespace rigsound::bench
