#include <fmt/format.h>

#include <cctype>
#include <cstring>
#include <fstream>

#include "chart/markup_text.hpp"
#include "chart/number_word.hpp"
#include "report/bank_page.hpp"
#include "report/page_frame.hpp"
#include "report/player.hpp"
#include "report/report_section.hpp"
#include "rigsound/analysis/report.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;
using chart::number_word;

namespace {

/// A column of the table; a page too narrow for it shows each cell with its name.
struct Column {
  const char *name, *unit;
  bool is_number;
  std::string (*text)(const AnalysedPart& part);
};

std::string unless_zero(double value, int digits) { return value > 0 ? number_word(value, digits) : "–"; }

const Column kColumns[] = {
    {"Situation", "", false, [](const AnalysedPart& p) { return std::string(name(p.part.label.situation)); }},
    {"Rods", "", true, [](const AnalysedPart& p) { return unless_zero(p.part.label.rods, 0); }},
    {"Feed", "bar", true, [](const AnalysedPart& p) { return unless_zero(p.part.label.feed_bar, 0); }},
    {"Rock", "", false,
     [](const AnalysedPart& p) {
       return p.part.label.rock.empty() ? "–" : chart::markup_text(p.part.label.rock);
     }},
    {"Rate", "Hz", true, [](const AnalysedPart& p) { return number_word(p.figures.rate_hz, 2); }},
    {"Clicks", "found", true, [](const AnalysedPart& p) { return std::to_string(p.figures.clicks_found); }},
    {"Level", "dB re full scale", true,
     [](const AnalysedPart& p) { return number_word(p.figures.level_db, 1); }},
    {"SNR", "dB", true, [](const AnalysedPart& p) { return number_word(p.figures.snr_db, 1); }},
    {"Spectrum", "dB off target", true,
     [](const AnalysedPart& p) { return number_word(p.figures.ltas_error_db, 2); }},
    {"Spectrum", "dB off denoised", true,
     [](const AnalysedPart& p) { return number_word(p.figures.ltas_denoised_error_db, 2); }},
    {"Modulation", "off by dB", true,
     [](const AnalysedPart& p) { return number_word(p.figures.modulation_error_db, 2); }},
};

std::string summary_head() {
  std::string html = "<table class=\"cards\">\n<thead><tr><th>Bank</th>";
  for (const Column& c : kColumns)
    html += fmt::format("<th{}>{}{}</th>", c.is_number ? " class=\"n\"" : "", c.name,
                        *c.unit == 0 ? "" : fmt::format("<small>{}</small>", c.unit));
  return html + "<th></th></tr></thead><tbody>\n";
}

std::string summary_row(const AnalysedPart& p) {
  std::string html =
      fmt::format("<tr><th scope=\"row\"><a href=\"#{0}\">{0}</a></th>", chart::markup_text(p.part.bank));
  for (const Column& c : kColumns)
    html += fmt::format("<td{} data-name=\"{}{}{}\">{}</td>", c.is_number ? " class=\"n\"" : "", c.name,
                        *c.unit == 0 ? "" : ", ", c.unit, c.text(p));
  html += "<td class=\"warn\">";
  if (!p.warnings.empty()) html += counted(p.warnings.size(), "warning", "warnings");
  return html + "</td></tr>\n";
}

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
    html += summary_head();
    for (const AnalysedPart& p : result.banks) html += summary_row(p);
    html += "</tbody></table>\n";
  }
  if (result.failures.empty()) return html;
  html += "<h2>Without a bank</h2>\n<ul>\n";
  for (const std::string& failure : result.failures) html += "<li>" + chart::markup_text(failure) + "</li>\n";
  return html + "</ul>\n";
}

/// From the page at `from` to the file `to`, as a link.
std::string link(const fs::path& from, const fs::path& to) {
  std::string text;
  for (const char c : fs::absolute(to).lexically_proximate(fs::absolute(from).parent_path()).generic_string())
    text += std::isalnum(static_cast<unsigned char>(c)) || std::strchr("/._-", c) != nullptr
                ? std::string(1, c)
                : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return text;
}

/// Without its sound where a page of many banks would grow too large.
std::string without_player(std::string section) {
  constexpr const char* kEnd = "</figure>\n";
  const std::size_t from = section.find("<figure class=\"player\""), to = section.find(kEnd);
  if (from == std::string::npos || to == std::string::npos) return section;
  return section.replace(from, to + std::strlen(kEnd) - from,
                         "<p class=\"quiet\">Its sound is on its own page.</p>\n");
}

}  // namespace

void write_report(const fs::path& path, const fs::path& sound_set, const AnalyzerResult& result) {
  constexpr std::size_t kMostHeard = 24;  // banks, about a megabyte each
  AtomicFile file(path);
  std::ofstream out(file.temporary(), std::ios::in | std::ios::out | std::ios::binary);
  out << page_start("Analysis report", "") << summary(result);
  std::size_t heard = 0;
  for (const AnalysedPart& p : result.banks) {
    const fs::path page = bank_page_path(sound_set, p.part.bank);
    const std::string section = section_in(page);
    out << fmt::format(
               "<section id=\"{0}\"><h2><span><a href=\"{1}\">own page</a> <a href=\"#symbols\">symbols</a> "
               "<a "
               "href=\"#top\">↑ index</a></span>{0}</h2>\n",
               chart::markup_text(p.part.bank), link(path, page))
        << bank_words(p) << (++heard <= kMostHeard ? section : without_player(section)) << "</section>\n";
  }
  if (!result.banks.empty()) out << symbol_legend() << kPlayerScript;
  out << kPageEnd;
  out.close();
  if (!out) throw DeviceError(path.string() + ": cannot be written");
  file.commit();
}

}  // namespace rigsound::analysis
