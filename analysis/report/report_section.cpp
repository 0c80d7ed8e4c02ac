#include "report/report_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/panels.hpp"
#include "rigsound/analysis/resynth.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSynthesisSeconds = 4;
constexpr std::uint64_t kSynthesisSeed = 1;

std::string row(const char* css_class, const std::string& panels) {
  return fmt::format("<div class=\"{}\">\n{}</div>\n", css_class, panels);
}

}  // namespace

std::string report_section(const PartAnalysis& analysis) {
  const Segments drilling = with_drilling(analysis.segments);
  const auto shown = std::find_if(analysis.segments.begin(), analysis.segments.end(), has_drilling);
  const std::vector<float>& recorded =
      analysis.recorded[static_cast<std::size_t>(shown - analysis.segments.begin())];
  const ClickBank& bank = analysis.built.bank;
  const std::vector<float> synthesis = resynthesise(bank, kSynthesisSeconds, kSynthesisSeed).sound;
  return row("three", spectrogram_panels(recorded, *shown)) + row("one", waveform_panel(recorded, *shown)) +
         row("three", envelope_panel(*shown) + gap_panel(drilling, bank) + amplitude_panel(drilling, bank)) +
         row("two", third_octave_panel(drilling, synthesis) + modulation_panel(drilling, synthesis)) +
         row("five", click_panels(bank));
}

}  // namespace rigsound::analysis
