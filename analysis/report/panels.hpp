// The charts of one bank. All functions: thread OFF.
#pragma once

#include <string>

#include "bank/segment.hpp"
#include "chart/svg_plot.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound::analysis {

// Sizes of charts that fit every page.
constexpr chart::PlotSize kThird{392, 210}, kFifth{233, 120};

/// Of wide charts, which are drawn twice: a page of 1200 pixels and one of 420 both show text in its size.
struct Sheet {
  const char* css_class;
  double full, half;    ///< pixels, of a chart over the whole width and one beside another
  std::size_t columns;  ///< of a waveform
  int ticks;            ///< of an axis of time
  double longest_s;     ///< of an axis of time
};
constexpr Sheet kWideSheet{"broad", 1200, 594, 720, 10, 2}, kNarrowSheet{"narrow", 392, 392, 240, 4, 0.7};

/// One segment of a part, as far as it is shown.
struct ShownSegment {
  std::vector<float> recorded, drilling;
  const ChainResult& chain;
  double start_s;  ///< in the recording
};

/// On one axis of time, as long as the sheet allows: spectrograms of the recording, of what was taken away
/// and of what is left; below them the waveform before and after with a line at every detected click.
std::string time_panels(const ShownSegment& segment, const Sheet& sheet);
/// How likely every window of the part is drilling.
std::string verdict_panel(const std::vector<VerdictWindow>& verdict, double start_s, const Sheet& sheet);
/// Mean level after a click, as recorded and as whitened for the fit, against the fitted envelope.
std::string envelope_panel(const ChainResult& segment);
/// Every click of the bank.
std::string click_panels(const ClickBank& bank);
/// What was measured against the distributions the engine draws from.
std::string gap_panel(const Segments& segments, const ClickBank& bank);
std::string amplitude_panel(const Segments& segments, const ClickBank& bank);
/// Recorded against resynthesised.
std::string third_octave_panel(const Segments& segments, const std::vector<float>& synthesis,
                               const Sheet& sheet);
std::string modulation_panel(const Segments& segments, const std::vector<float>& synthesis,
                             const Sheet& sheet);

}  // namespace rigsound::analysis
