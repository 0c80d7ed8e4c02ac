// What looks wrong with a bank, or with a bank among its neighbours.
#pragma once

#include <string>
#include <vector>

#include "rigsound/analysis/analyzer.hpp"

namespace rigsound::analysis {

/// Warnings about one bank: too few clicks, low SNR, clicks shorter than their decay, rate out of range,
/// segments without drilling, a synthesis far from the recording. Thread: OFF.
std::vector<std::string> lint_bank(const AnalysedPart& part, int wanted_clicks);

/// Adds warnings to banks that do not fit their series: rate or level outside of both neighbours in rods
/// (same situation and rock) or in feed (same rods and rock); faster in overfeed or louder in underfeed than
/// in normal drilling; a level far from the others'. Each says what was heard and what may be wrong. Thread:
/// OFF.
void lint_series(std::vector<AnalysedPart>& parts);

}  // namespace rigsound::analysis
