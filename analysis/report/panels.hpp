// The charts of one bank. All functions: thread OFF.
#pragma once

#include <string>

#include "bank/segment.hpp"
#include "chart/svg_plot.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

// Sizes of the charts side by side on a page of 1200 pixels.
constexpr chart::PlotSize kThird{392, 210}, kHalf{594, 230}, kFifth{233, 120};

/// One segment of a part, as far as it is shown.
struct ShownSegment {
  std::vector<float> recorded;
  const ChainResult& chain;
  double start_s;  ///< in the recording
};

/// On one axis of time, at most two seconds: spectrograms of the recording, of what was taken away and of
/// what is left; below them the waveform before and after with a line at every detected click.
std::string time_panels(const ShownSegment& segment);
/// Mean level after a click, as recorded and as whitened for the fit, against the fitted envelope.
std::string envelope_panel(const ChainResult& segment);
/// Every click of the bank.
std::string click_panels(const ClickBank& bank);
/// What was measured against the distributions the engine draws from.
std::string gap_panel(const Segments& segments, const ClickBank& bank);
std::string amplitude_panel(const Segments& segments, const ClickBank& bank);
/// Recorded against resynthesised.
std::string third_octave_panel(const Segments& segments, const std::vector<float>& synthesis);
std::string modulation_panel(const Segments& segments, const std::vector<float>& synthesis);

}  // namespace rigsound::analysis
