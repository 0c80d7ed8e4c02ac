// What looks wrong with a bank, or with a bank among its neighbours.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

/// Warnings about one bank: too few clicks, low SNR, clicks shorter than their decay, rate out of range,
/// segments without drilling, a synthesis far from the recording. Thread: OFF.
std::vector<std::string> lint_bank(const AnalysedPart& part, int wanted_clicks);

/// Adds a warning to every bank whose T0 or level is out of order: between its neighbours in rod count (same
/// situation and rock), or against normal drilling over the feed (same rods and rock). Thread: OFF.
void lint_series(std::vector<AnalysedPart>& parts);

}  // namespace rigsound::analysis
