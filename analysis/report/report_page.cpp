#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "analyzer/finished_bank.hpp"
#include "report/html_text.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>rigsound analysis report</title>
<style>
:root { color-scheme: light dark; --ink: #1b1b1f; --paper: #fff; --faint: #d9d9de; --grey: #77777f;
  --first: #1f66b0; --second: #b4b7c0; --third: #c2410c; --onset: #15803d; --warn: #b45309; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8ec; --paper: #17171b; --faint: #3a3a42; --grey: #9a9aa4;
  --first: #6db1ff; --second: #5b5d68; --third: #ff9a5c; --onset: #5bd68a; --warn: #f5b04c; } }
@media print { :root { --ink: #000; --paper: #fff; --faint: #ccc; --grey: #555; --first: #1f66b0; --second: #b4b7c0;
  --third: #c2410c; --onset: #15803d; --warn: #8a4207; } section { break-inside: avoid-page; } }
body { background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, sans-serif; max-width: 1180px;
  margin: 2em auto; padding: 0 1em; }
h1 { font-size: 1.5em } h2 { font-size: 1.15em; margin: 2.2em 0 .2em } p { margin: .3em 0 }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums }
th, td { text-align: left; padding: .2em .6em; border-bottom: 1px solid var(--faint) }
td.n, th.n { text-align: right } .warn { color: var(--warn) } .quiet { color: var(--grey) }
a { color: inherit } .wide { overflow-x: auto }
section { content-visibility: auto; contain-intrinsic-size: auto 1000px }
.one, .two, .three, .five { display: grid; gap: .4em; margin: .4em 0 }
.two { grid-template-columns: repeat(auto-fit, minmax(340px, 1fr)) }
.three { grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)) }
.five { grid-template-columns: repeat(auto-fit, minmax(170px, 1fr)) }
svg { width: 100%; height: auto; display: block } image { image-rendering: pixelated }
svg text { font: 9.5px system-ui, sans-serif; fill: var(--ink) } svg .title { font-weight: 600; font-size: 11px }
svg .tick { fill: var(--grey) } svg .x { text-anchor: middle } svg .y { text-anchor: end }
.axis { fill: none; stroke: var(--grey) } .grid { stroke: var(--faint); stroke-width: .5 }
.line { fill: none; stroke-width: 1.3 } .area { stroke: none }
.line.first { stroke: var(--first) } .line.third { stroke: var(--third) } .line.onset { stroke: var(--onset); stroke-width: .8 }
.area.first { fill: var(--first) } .area.second { fill: var(--second) }
svg tspan { font-weight: 600 } tspan.first { fill: var(--first) } tspan.second { fill: var(--grey) }
tspan.third { fill: var(--third) } tspan.onset { fill: var(--onset) }
</style></head><body>
<h1>Analysis report</h1>
)";

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "–";
}

std::string summary_row(const AnalysedPart& p) {
  const BankFigures& f = p.figures;
  const std::string bank = html_text(p.part.bank);
  const std::string warnings =
      p.warnings.empty() ? "" : fmt::format("<span class=\"warn\">{}</span>", p.warnings.size());
  return fmt::format(
      "<tr><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td class=\"n\">{2}</td><td class=\"n\">{3}</td><td "
      "class=\"n\">{4}</td>"
      "<td class=\"n\">{5}</td><td class=\"n\">{6}</td><td class=\"n\">{7}</td><td class=\"n\">{8}</td><td "
      "class=\"n\">{9}</td></tr>\n",
      bank, name(p.part.label.situation), p.part.label.rods, number(f.rate_hz, 2), f.clicks_found,
      number(f.level_db, 1), number(f.snr_db, 1), number(f.ltas_error_db, 2),
      number(f.modulation_error_db, 2), warnings);
}

std::string summary(const AnalyzerResult& result) {
  std::string html = fmt::format("<p>{} banks, {} recordings or parts without one.</p>\n",
                                 result.banks.size(), result.failures.size());
  html +=
      "<div class=\"wide\"><table><tr><th>Bank</th><th>Situation</th><th class=\"n\">Rods</th><th "
      "class=\"n\">Rate, Hz</th>"
      "<th class=\"n\">Clicks</th><th class=\"n\">Level, dB</th><th class=\"n\">SNR, dB</th>"
      "<th class=\"n\">Spectrum off by, dB</th><th class=\"n\">Modulation off by, dB</th><th "
      "class=\"n\">Warnings</th></tr>\n";
  for (const AnalysedPart& p : result.banks) html += summary_row(p);
  html += "</table></div>\n";
  if (result.failures.empty()) return html;
  html += "<h2>Without a bank</h2>\n<ul>\n";
  for (const std::string& failure : result.failures) html += "<li>" + html_text(failure) + "</li>\n";
  return html + "</ul>\n";
}

std::string section_head(const AnalysedPart& p) {
  const Label& l = p.part.label;
  std::string html =
      fmt::format("<section id=\"{0}\"><h2>{0}</h2>\n<p>{1}", html_text(p.part.bank), name(l.situation));
  if (l.rods > 0) html += fmt::format(", {} rods", l.rods);
  if (!l.rock.empty()) html += ", " + html_text(l.rock);
  if (l.rpm > 0) html += fmt::format(", {:.0f} r/min", l.rpm);
  html += fmt::format(
      " · {:.2f} Hz · {} clicks found, {} in the bank · decay to −60 dB {:.0f} ms · level {} dB · SNR {} "
      "dB</p>\n",
      p.figures.rate_hz, p.figures.clicks_found, p.clicks, 1e3 * p.figures.decay_s,
      number(p.figures.level_db, 1), number(p.figures.snr_db, 1));
  html += fmt::format("<p class=\"quiet\">{}", html_text(p.part.recording.string()));
  if (!p.part.whole()) html += fmt::format(", {:.3f} to {:.3f} s", l.start_s, l.end_s);
  html +=
      fmt::format(", drilling in {} of {} segments</p>\n", p.figures.segments_drilling, p.figures.segments);
  for (const std::string& warning : p.warnings) html += "<p class=\"warn\">" + html_text(warning) + "</p>\n";
  return html;
}

}  // namespace

void write_report(const fs::path& path, const fs::path& sound_set, const AnalyzerResult& result) {
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::binary | std::ios::trunc);
  out << kHead << summary(result);
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
