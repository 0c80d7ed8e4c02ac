#include "report/bank_page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "chart/markup_text.hpp"
#include "chart/number_word.hpp"
#include "report/page_frame.hpp"
#include "report/player.hpp"
#include "report/report_section.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;
using chart::number_word;

namespace {

constexpr const char *kBefore = "<main>\n", *kAfter = "</main>\n";

}  // namespace

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string bank_words(const AnalysedPart& p) {
  const Label& l = p.part.label;
  std::string html = fmt::format("<p>{}", name(l.situation));
  if (l.rods > 0) html += ", " + counted(static_cast<std::size_t>(l.rods), "rod", "rods");
  if (!l.rock.empty()) html += ", " + chart::markup_text(l.rock);
  if (l.feed_bar > 0) html += fmt::format(", feed {} bar", number_word(l.feed_bar, 1));
  if (l.percussion_bar > 0) html += fmt::format(", percussion {} bar", number_word(l.percussion_bar, 1));
  if (l.rpm > 0) html += fmt::format(", {:.0f} r/min", l.rpm);
  html += fmt::format(
      " · {} Hz · {} clicks found, {} in the bank · decay to −60 dB {:.0f} ms · level {} dB · SNR {} dB · "
      "spectrum off by {} dB from its target, by {} dB from the denoised recording, modulation by {} "
      "dB</p>\n",
      number_word(p.figures.rate_hz, 2), p.figures.clicks_found, p.clicks, 1e3 * p.figures.decay_s,
      number_word(p.figures.level_db, 1), number_word(p.figures.snr_db, 1),
      number_word(p.figures.ltas_error_db, 2), number_word(p.figures.ltas_denoised_error_db, 2),
      number_word(p.figures.modulation_error_db, 2));
  html += fmt::format("<p class=\"quiet\">{}", chart::markup_text(p.part.recording.string()));
  if (!p.part.whole()) html += fmt::format(", {:.3f} to {:.3f} s", l.start_s, l.end_s);
  html += fmt::format(", drilling in {} of {}</p>\n", p.figures.segments_drilling,
                      counted(static_cast<std::size_t>(p.figures.segments), "segment", "segments"));
  for (const std::string& warning : p.warnings)
    html += "<p class=\"warn\">" + chart::markup_text(warning) + "</p>\n";
  return html;
}

std::string bank_page(const AnalysedPart& part, const std::string& section) {
  return page_start("Bank " + part.part.bank, "") + bank_words(part) + kBefore + section + kAfter +
         symbol_legend() + kPlayerScript + kPageEnd;
}

fs::path bank_page_path(const fs::path& sound_set, const std::string& bank) {
  return sound_set / "banks" / bank / "report.html";
}

std::string section_in(const fs::path& page) {
  std::ifstream file(page, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  const std::string html = text.str();
  const std::size_t before = html.find(kBefore), after = html.rfind(kAfter);
  if (before == std::string::npos || after == std::string::npos) return "";
  const std::size_t from = before + std::string(kBefore).size();
  return html.substr(from, after - from);
}

}  // namespace rigsound::analysis
