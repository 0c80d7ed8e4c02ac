#include "report/report_section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/panels.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/resynth.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSynthesisSeconds = 4;
constexpr std::uint64_t kSynthesisSeed = 1;

std::string row(const char* css_class, const std::string& panels) {
  return fmt::format("<div class=\"{}\">\n{}</div>\n", css_class, panels);
}

ShownSegment shown_segment(const ReportedPart& part, const DrillingSegment& segment) {
  const auto begin = part.recorded.begin() + segment.begin;
  return {{begin, begin + static_cast<long>(segment.result.drilling.size())},
          segment.result,
          part.start_s + static_cast<double>(segment.begin) / kAnalysisRate};
}

/// What the engine draws from and what was fitted, in the paper's symbols.
std::string bank_figures(const ClickBank& bank) {
  const double ms = 1e3 / bank.sample_rate, decibels = 20 / std::log(10.0);
  std::string html = "<dl>";
  const auto add = [&html](const char* symbol, const std::string& value) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", symbol, value);
  };
  add("T<sub>0</sub>", fmt::format("{:.2f} ms", bank.mean_gap_samples * ms));
  add("σ<sub>T</sub>", fmt::format("{:.2f} ms ({:.1f} %)", bank.gap_deviation_samples * ms,
                                   100 * bank.gap_deviation_samples / bank.mean_gap_samples));
  add("r<sub>T</sub>", fmt::format("{:.2f}", bank.gap_correlation));
  add("missed", fmt::format("{:.1f} %", 100 * bank.miss_share));
  add("doubled", fmt::format("{:.1f} %", 100 * bank.double_share));
  add("B", fmt::format("{:.3g}", bank.mean_amplitude));
  add("σ<sub>B</sub>", fmt::format("{:.0f} %", 100 * bank.amplitude_deviation / bank.mean_amplitude));
  add("r<sub>B</sub>", fmt::format("{:.2f}", bank.amplitude_correlation));
  add("N<sub>a</sub>", fmt::format("{:.2f} ms", bank.attack_samples * ms));
  add("α<sub>a</sub> N<sub>a</sub>", fmt::format("{:.2f}", bank.attack_bend * bank.attack_samples));
  add("α<sub>d</sub>", fmt::format("{:.2f} dB/ms", bank.decay * decibels / ms));
  return html + "</dl>\n";
}

}  // namespace

std::filesystem::path report_section_path(const std::filesystem::path& sound_set, const std::string& bank) {
  return sound_set / "banks" / bank / "report.html";
}

std::string report_section(const ReportedPart& part) {
  const Segments drilling = learnable(part.drilling);
  const ShownSegment shown = shown_segment(part, drilling.front());
  const ClickBank& bank = part.bank;
  const std::vector<float> synthesis = resynthesise(bank, kSynthesisSeconds, kSynthesisSeed).sound;
  return bank_figures(bank) + row("one", time_panels(shown)) +
         row("three",
             envelope_panel(shown.chain) + gap_panel(drilling, bank) + amplitude_panel(drilling, bank)) +
         row("two", third_octave_panel(drilling, synthesis) + modulation_panel(drilling, synthesis)) +
         row("five", click_panels(bank));
}

}  // namespace rigsound::analysis
