#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "chart/markup_text.hpp"
#include "chart/style_sheet.hpp"
#include "report/page_style.hpp"
#include "report/report_section.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", value, digits);
  return text[0] == '-' ? "−" + text.substr(1) : text;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string number_cell(const std::string& text) { return "<td class=\"n\">" + text + "</td>"; }

std::string summary_row(const AnalysedPart& p) {
  const BankFigures& f = p.figures;
  const Label& label = p.part.label;
  std::string html = fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td><td>{1}</td>",
                                 chart::markup_text(p.part.bank), name(label.situation));
  html += number_cell(label.rods > 0 ? std::to_string(label.rods) : "–");
  html += number_cell(label.feed_bar > 0 ? number(label.feed_bar, 0) : "–");
  html += fmt::format("<td>{}</td>", label.rock.empty() ? "–" : chart::markup_text(label.rock));
  html += number_cell(number(f.rate_hz, 2)) + number_cell(std::to_string(f.clicks_found)) +
          number_cell(number(f.level_db, 1)) + number_cell(number(f.snr_db, 1)) +
          number_cell(number(f.ltas_error_db, 2)) + number_cell(number(f.modulation_error_db, 2));
  html += "<td class=\"warn\">";
  if (!p.warnings.empty()) html += counted(p.warnings.size(), "warning", "warnings");
  return html + "</td></tr>\n";
}

constexpr const char* kSummaryHead =
    "<div class=\"wide\"><table>\n<tr><th>Bank</th><th>Situation</th><th class=\"n\">Rods</th><th "
    "class=\"n\">Feed<small>bar</small></th><th>Rock</th>"
    "<th class=\"n\">Rate<small>Hz</small></th><th class=\"n\">Clicks<small>found</small></th>"
    "<th class=\"n\">Level<small>dB re full scale</small></th><th class=\"n\">SNR<small>dB</small></th>"
    "<th class=\"n\">Spectrum<small>off by dB</small></th><th class=\"n\">Modulation<small>off by "
    "dB</small></th>"
    "<th></th></tr>\n";

std::string summary(const AnalyzerResult& result) {
  std::size_t warned = 0;
  for (const AnalysedPart& p : result.banks) warned += p.warnings.empty() ? 0 : 1;
  std::string html = "<p>" + counted(result.banks.size(), "bank", "banks");
  if (warned > 0) html += fmt::format(", {} with warnings", warned);
  if (!result.failures.empty())
    html += "; " + counted(result.failures.size(), "part or recording", "parts or recordings") +
            " without a bank";
  html += ". Spectrum and modulation compare what the bank plays with what was recorded.</p>\n";
  if (!result.banks.empty()) {
    html += kSummaryHead;
    for (const AnalysedPart& p : result.banks) html += summary_row(p);
    html += "</table></div>\n";
  }
  if (result.failures.empty()) return html;
  html += "<h2>Without a bank</h2>\n<ul>\n";
  for (const std::string& failure : result.failures) html += "<li>" + chart::markup_text(failure) + "</li>\n";
  return html + "</ul>\n";
}

std::string section_head(const AnalysedPart& p) {
  const Label& l = p.part.label;
  std::string html = fmt::format("<section id=\"{0}\"><h2><a href=\"#top\">↑ index</a>{0}</h2>\n<p>{1}",
                                 chart::markup_text(p.part.bank), name(l.situation));
  if (l.rods > 0) html += ", " + counted(static_cast<std::size_t>(l.rods), "rod", "rods");
  if (!l.rock.empty()) html += ", " + chart::markup_text(l.rock);
  if (l.feed_bar > 0) html += fmt::format(", feed {} bar", number(l.feed_bar, 1));
  if (l.percussion_bar > 0) html += fmt::format(", percussion {} bar", number(l.percussion_bar, 1));
  if (l.rpm > 0) html += fmt::format(", {:.0f} r/min", l.rpm);
  html += fmt::format(
      " · {} Hz · {} clicks found, {} in the bank · decay to −60 dB {:.0f} ms · level {} dB · SNR {} dB · "
      "spectrum off by {} dB, modulation by {} dB</p>\n",
      number(p.figures.rate_hz, 2), p.figures.clicks_found, p.clicks, 1e3 * p.figures.decay_s,
      number(p.figures.level_db, 1), number(p.figures.snr_db, 1), number(p.figures.ltas_error_db, 2),
      number(p.figures.modulation_error_db, 2));
  html += fmt::format("<p class=\"quiet\">{}", chart::markup_text(p.part.recording.string()));
  if (!p.part.whole()) html += fmt::format(", {:.3f} to {:.3f} s", l.start_s, l.end_s);
  html += fmt::format(", drilling in {} of {}</p>\n", p.figures.segments_drilling,
                      counted(static_cast<std::size_t>(p.figures.segments), "segment", "segments"));
  for (const std::string& warning : p.warnings)
    html += "<p class=\"warn\">" + chart::markup_text(warning) + "</p>\n";
  return html;
}

}  // namespace

void write_report(const fs::path& path, const fs::path& sound_set, const AnalyzerResult& result) {
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary | std::ios::trunc);
  out << kPageStart << chart::page_colours() << kPageStyle << chart::chart_styles() << kPageTop
      << summary(result);
  for (const AnalysedPart& p : result.banks) {
    out << section_head(p);
    std::ifstream section(report_section_path(sound_set, p.part.bank), std::ios::binary);
    if (section) out << section.rdbuf();
    out << "</section>\n";
  }
  out << "</body></html>\n";
  out.close();
  if (!out) throw DeviceError(path.string() + ": cannot be written");
  file.commit();
}

}  // namespace rigsound::analysis
