#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include "chart/markup_text.hpp"
#include "chart/number_word.hpp"
#include "contrast/contrast_charts.hpp"
#include "contrast/listening.hpp"
#include "report/page_frame.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
using chart::number_word;

namespace {

// On top of the report's style.
constexpr const char* kContrastStyle = R"(
body { max-width: 1180px } .verdicts { font-size: 1.25em; line-height: 1.4; margin: 1em 0 1.4em; padding: 0; list-style: none }
.verdicts li { margin: .5em 0; padding-left: .8em; border-left: 4px solid var(--onset) }
.verdicts li.bad { border-left-color: var(--third) }
section { content-visibility: visible; margin-bottom: 1.8em } h2 { margin-bottom: .5em }
.charts { display: grid; gap: 1.2em; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)) }
.matrix { border-collapse: separate; border-spacing: 3px; width: auto } .matrix th, .matrix td { border: 0 }
.matrix th { font-weight: 600; vertical-align: middle } .matrix tbody th { text-align: right }
.matrix td { padding: .45em .6em; border-radius: 5px; text-align: center; min-width: 5.2em;
  background: color-mix(in srgb, var(--first) calc(var(--p) * 1%), var(--paper)) }
.matrix td.none { background: none } .matrix td.same { background: none; outline: 2px solid var(--third); outline-offset: -2px }
.matrix b { display: block; font-size: 1.15em } .matrix small { display: block; white-space: nowrap; opacity: .8 }
.sounds { display: flex; flex-wrap: wrap; gap: 1em 2.5em; align-items: flex-start }
.sounds > div { flex: 1 1 auto; min-width: 0; max-width: 100% }
@media (max-width: 640px) { body { padding: 0 .8em } .matrix { border-spacing: 2px; font-size: .74em }
  .matrix td { min-width: 0; padding: .35em .3em } .matrix small { white-space: normal } h1 { font-size: 1.35em }
  .verdicts { font-size: 1.08em } }
@media print { .charts { grid-template-columns: 1fr 1fr } .matrix td { print-color-adjust: exact; -webkit-print-color-adjust: exact } }
)";

bool is_bad(const std::string& verdict) {
  return verdict.find("cannot") != std::string::npos || verdict.find("Not told") != std::string::npos;
}

/// Numbers stay beside their units.
std::string unbroken(const std::string& sentence) {
  std::string text = chart::markup_text(sentence);
  for (const std::string_view unit : {" bar", " %"})
    for (std::size_t at = 0; (at = text.find(unit, at)) != std::string::npos; ++at)
      if (at > 0 && std::isdigit(static_cast<unsigned char>(text[at - 1]))) text.replace(at, 1, "&nbsp;");
  return text;
}

std::string verdict_list(const Contrast& c) {
  std::string html = "<ul class=\"verdicts\">\n";
  for (const std::string& verdict : contrast_verdicts(c))
    html += fmt::format("<li{}>{}</li>\n", is_bad(verdict) ? " class=\"bad\"" : "", unbroken(verdict));
  return html + "</ul>\n";
}

const PairFigures& pair_of(const SubjectGroup& group, std::size_t a, std::size_t b) {
  return *std::find_if(group.pairs.begin(), group.pairs.end(), [&](const PairFigures& p) {
    return p.first == std::min(a, b) && p.second == std::max(a, b);
  });
}

/// Deeper blue the farther apart; outlined where two sounds cannot be told apart.
std::string cell(const PairFigures& pair, double farthest_db) {
  const double depth =
      6 + 40 * pair.third_octave_db / farthest_db;  // no deeper, so that ink stays legible on it
  return fmt::format(
      "<td{} style=\"--p:{:.0f}\" title=\"{:.0f} % of one-second excerpts told right; two runs of "
      "one "
      "sound are {:.2f} dB apart; modulation {:.2f} dB ({:.2f} dB), rate {:.1f} %, loudness {} "
      "phon\"><b>{:.1f} "
      "dB</b><small>{:.0f} % right</small></td>",
      pair.told_apart() ? "" : " class=\"same\"", depth, 100 * pair.right, pair.third_octave_floor_db,
      pair.modulation_db, pair.modulation_floor_db, 100 * pair.rate, number_word(pair.phon, 1),
      pair.third_octave_db, 100 * pair.right);
}

std::string matrix(const SubjectGroup& group) {
  double farthest = 1;
  for (const PairFigures& pair : group.pairs) farthest = std::max(farthest, pair.third_octave_db);
  const std::size_t n = group.subjects.size();
  std::string html = "<div class=\"wide\"><table class=\"matrix\"><thead><tr><th></th>";
  for (std::size_t j = 0; j + 1 < n; ++j)
    html += "<th>" + chart::markup_text(group.subjects[j].subject.name) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (std::size_t i = 1; i < n; ++i) {
    html += "<tr><th>" + chart::markup_text(group.subjects[i].subject.name) + "</th>";
    for (std::size_t j = 0; j + 1 < n; ++j)
      html += j < i ? cell(pair_of(group, i, j), farthest) : "<td class=\"none\"></td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string sound_table(const SubjectGroup& group) {
  std::string html =
      "<table class=\"cards\">\n<thead><tr><th></th><th class=\"n\">Feed<small>bar</small></th><th "
      "class=\"n\">Rate<small>impacts a second</small></th><th "
      "class=\"n\">Loudness<small>sone</small></th><th "
      "class=\"n\">Loudness level<small>phon</small></th><th>Bank</th></tr></thead><tbody>\n";
  for (const SubjectFigures& s : group.subjects)
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"n\" data-name=\"Feed, bar\">{:g}</td><td class=\"n\" "
        "data-name=\"Rate, impacts a second\">{}</td><td class=\"n\" data-name=\"Loudness, sone\">{}</td><td "
        "class=\"n\" data-name=\"Loudness level, phon\">{}</td><td data-name=\"Bank\">{}</td></tr>\n",
        chart::markup_text(s.subject.name), s.subject.setting.feed_bar, number_word(s.rate_hz, 1),
        number_word(s.loudness_sone, 1), number_word(s.loudness_phon, 1),
        s.subject.banks.empty() ? "–" : chart::markup_text(bank_list(s.subject)));
  return html + "</tbody></table>\n";
}

std::string group_section(const char* title, const SubjectGroup& group) {
  if (group.pairs.empty()) return "";
  return fmt::format(
             "<section><h2>{}</h2>\n<p class=\"quiet\">How far apart two of them are in third octaves, and "
             "how many "
             "one-second excerpts are told right; outlined: not told apart.</p>\n<div class=\"sounds\">",
             title) +
         matrix(group) + sound_table(group) + "</div></section>\n";
}

std::string chart_legend() {
  return fmt::format(
      "<p class=\"quiet\">Dots: measured at one feed. Curve without dots: Weibull function through them; "
      "orange: "
      "where "
      "{0:.0f} % are told right, with its 95 % interval; dashed and grey: {0:.0f} %. Ground: the situation "
      "at that "
      "feed.</p>\n",
      100 * kToldRight);
}

std::string method(const Contrast& c) {
  const ContrastOptions& o = c.options;
  return fmt::format(
      "<section class=\"quiet\"><h2>How it was measured</h2>\n<p>{} runs of {:g} s of each sound, every one "
      "with "
      "another seed. A distance is the mean absolute difference of 25 third-octave levels, 62.5 Hz to 16 "
      "kHz. Two "
      "sounds count as different when they are {:g} times as far apart as two runs of one of them, in third "
      "octaves, modulation or rate, and when a listener tells {:.0f} % of one-second excerpts "
      "right.</p>\n<p>The "
      "listener is a linear discriminant over third-octave levels, modulation spectrum and rate, learned "
      "from all "
      "runs but the one that it is asked about, with the noise of an ear: {:g} dB in each third octave, {:g} "
      "dB in "
      "each of modulation, {:g} % in the rate. It does not tire and knows both sounds; take its answer as "
      "the "
      "earliest feed that can be heard.</p>\n<p>Loudness by ISO 532-1 (Zwicker, stationary, free field), "
      "with {:g} "
      "dB SPL at the ear for a sine of full scale.</p></section>\n",
      o.runs, o.seconds, kFloors, 100 * kToldRight, kBandNoise_db, kModulationNoise_db, 100 * kRateNoise,
      o.full_scale_db_spl);
}

}  // namespace

void write_contrast_page(const std::filesystem::path& path, const Contrast& c) {
  std::string html = page_start("Can it be heard?", kContrastStyle) + "<p class=\"quiet\">Sound set " +
                     chart::markup_text(c.plan.sound_set.string()) + "</p>\n" + verdict_list(c);
  html += "<section><h2>From which feed on</h2>\n<div class=\"charts\">" + heard_chart(c) +
          distance_chart(c) + loudness_chart(c) + rate_chart(c) + "</div>\n" + chart_legend() +
          "</section>\n";
  html += group_section("The situations", c.situations) + group_section("Rods", c.rods) +
          group_section("Rocks", c.rocks) + method(c);
  write_file(path, html + kPageEnd);
}

}  // namespace rigsound::analysis
