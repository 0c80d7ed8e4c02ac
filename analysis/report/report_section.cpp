#include "report/report_section.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/panels.hpp"
#include "report/player.hpp"
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
  const auto begin = static_cast<std::size_t>(segment.begin);
  return {part.recorded.piece(begin, begin + segment.result.drilling.size()), segment.result.drilling.all(),
          segment.result, part.start_s + static_cast<double>(segment.begin) / kAnalysisRate};
}

/// The same charts for wide pages and for narrow ones, of which the style sheet shows one.
template <class Panels>
std::string both_rows(const char* css_class, Panels panels) {
  std::string html;
  for (const Sheet& sheet : {kWideSheet, kNarrowSheet})
    html += row(fmt::format("{} {}", css_class, sheet.css_class).c_str(), panels(sheet));
  return html;
}

/// What the engine draws from and what was fitted, in the paper's symbols.
struct Symbol {
  const char *html, *meaning;
  std::string (*value)(const ClickBank& bank);
};

double ms(const ClickBank& bank) { return 1e3 / bank.sample_rate; }

const Symbol kSymbols[] = {
    {"T<sub>0</sub>", "mean gap between clicks",
     [](const ClickBank& b) { return fmt::format("{:.2f} ms", b.mean_gap_samples * ms(b)); }},
    {"σ<sub>T</sub>", "standard deviation of the gaps, and its share of T<sub>0</sub>",
     [](const ClickBank& b) {
       return fmt::format("{:.2f} ms ({:.1f} %)", b.gap_deviation_samples * ms(b),
                          100 * b.gap_deviation_samples / b.mean_gap_samples);
     }},
    {"r<sub>T</sub>", "correlation of a gap with the one before",
     [](const ClickBank& b) { return fmt::format("{:.2f}", b.gap_correlation); }},
    {"missed", "gaps in which an impact is missing",
     [](const ClickBank& b) { return fmt::format("{:.1f} %", 100 * b.miss_share); }},
    {"doubled", "gaps that hold two impacts",
     [](const ClickBank& b) { return fmt::format("{:.1f} %", 100 * b.double_share); }},
    {"B", "mean amplitude of a click: root of its energy, full scale 1",
     [](const ClickBank& b) { return fmt::format("{:.3g}", b.mean_amplitude); }},
    {"σ<sub>B</sub>", "standard deviation of the amplitudes over B",
     [](const ClickBank& b) {
       return fmt::format("{:.0f} %", 100 * b.amplitude_deviation / b.mean_amplitude);
     }},
    {"r<sub>B</sub>", "correlation of an amplitude with the one before",
     [](const ClickBank& b) { return fmt::format("{:.2f}", b.amplitude_correlation); }},
    {"N<sub>a</sub>", "length of the attack",
     [](const ClickBank& b) { return fmt::format("{:.2f} ms", b.attack_samples * ms(b)); }},
    {"α<sub>a</sub> N<sub>a</sub>", "bend of the attack; 0: it rises in a straight line",
     [](const ClickBank& b) { return fmt::format("{:.2f}", b.attack_bend * b.attack_samples); }},
    {"α<sub>d</sub>", "how fast a click decays",
     [](const ClickBank& b) { return fmt::format("{:.2f} dB/ms", b.decay * 20 / std::log(10.0) / ms(b)); }},
};

std::string bank_figures(const ClickBank& bank) {
  std::string html = "<dl>";
  for (const Symbol& symbol : kSymbols)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", symbol.html, symbol.value(bank));
  return html + "</dl>\n";
}

}  // namespace

std::string report_section(const ReportedPart& part) {
  const Segments drilling = learnable(part.drilling);
  const ShownSegment shown = shown_segment(part, drilling.front());
  const ClickBank& bank = part.bank;
  const std::vector<float> synthesis = resynthesise(bank, kSynthesisSeconds, kSynthesisSeed).sound;
  return player({shown.recorded, shown.drilling, synthesis, shown.start_s}) + bank_figures(bank) +
         both_rows("one",
                   [&](const Sheet& sheet) {
                     return time_panels(shown, sheet) + verdict_panel(part.verdict, part.start_s, sheet);
                   }) +
         row("three",
             envelope_panel(shown.chain) + gap_panel(drilling, bank) + amplitude_panel(drilling, bank)) +
         both_rows("two",
                   [&](const Sheet& sheet) {
                     return third_octave_panel(drilling, synthesis, sheet) +
                            modulation_panel(drilling, synthesis, sheet);
                   }) +
         row("five", click_panels(bank));
}

std::string symbol_legend() {
  std::string html = "<section class=\"legend\"><h2 id=\"symbols\">What the symbols mean</h2>\n<dl>";
  for (const Symbol& symbol : kSymbols)
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", symbol.html, symbol.meaning);
  return html +
         "</dl>\n<p>Level: of the drilling, mean power. SNR: drilling over background. Envelope: mean power "
         "after "
         "a click; whitened: as the fit sees it. Engine: what the synthesiser draws its gaps and amplitudes "
         "from. Spectrograms share one scale, 0 dB being the loudest of the recording.</p></section>\n";
}

}  // namespace rigsound::analysis
