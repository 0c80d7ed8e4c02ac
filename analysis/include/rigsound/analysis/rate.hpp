// The sampling rate of everything the analysis computes.
#pragma once

namespace rigsound::analysis {

constexpr double kAnalysisRate = 48000;  ///< Hz; recordings are resampled to it when they are read

}  // namespace rigsound::analysis
