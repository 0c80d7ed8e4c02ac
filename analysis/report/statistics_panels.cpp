// Panels that show figures: histograms and spectra.
#include <algorithm>

#include "bank/recorded_levels.hpp"
#include "chart/svg_plot.hpp"
#include "report/measured_clicks.hpp"
#include "report/panels.hpp"
#include "rigsound/analysis/bank_comparison.hpp"

namespace rigsound::analysis {
namespace {

using chart::Axis, chart::frequency_axis, chart::linear_axis, chart::Role, chart::SvgPlot;

/// A histogram with the lognormal the engine draws from.
std::string panel(const char* title, const char* unit, const Histogram& histogram) {
  const double top = 1.1 * *std::max_element(histogram.share.begin(), histogram.share.end());
  SvgPlot plot(title, linear_axis(unit, histogram.edges.front(), histogram.edges.back()),
               linear_axis("share of clicks", 0, top, 4), kThird);
  plot->bars(histogram.edges, histogram.share, Role::kFirst);
  plot->line(histogram.engine.x, histogram.engine.y, {Role::kThird, 1.6});
  plot->legend("measured", Role::kFirst);
  plot->legend("engine", Role::kThird);
  return plot.svg();
}

/// Down from a little above the loudest of both.
Axis level_axis(std::string label, const BandLevels& a, const BandLevels& b, double range_db) {
  const double loudest = std::max(*std::max_element(a.level_db.begin(), a.level_db.end()),
                                  *std::max_element(b.level_db.begin(), b.level_db.end()));
  return linear_axis(std::move(label), loudest + 3 - range_db, loudest + 3);
}

std::string spectrum(const char* title, Axis x, Axis y, const BandLevels& recorded,
                     const BandLevels& synthesised, const Sheet& sheet) {
  constexpr double kHeight = 230;
  SvgPlot plot(title, std::move(x), std::move(y), {sheet.half, kHeight});
  plot->line(recorded.centre_hz, recorded.level_db, {Role::kFirst, 1.6});
  plot->line(synthesised.centre_hz, synthesised.level_db, {Role::kThird, 1.6});
  plot->legend("recorded", Role::kFirst);
  plot->legend("synthesised", Role::kThird);
  return plot.svg();
}

}  // namespace

std::string gap_panel(const Segments& segments, const ClickBank& bank) {
  return panel("Gaps between clicks", "ms", gap_histogram(gaps_ms(segments), bank));
}

std::string amplitude_panel(const Segments& segments, const ClickBank& bank) {
  return panel("Amplitudes of clicks", "over their mean",
               amplitude_histogram(amplitudes_over_mean(segments), bank));
}

std::string third_octave_panel(const Segments& segments, const std::vector<float>& synthesis,
                               const Sheet& sheet) {
  const BandLevels recorded = given_back(segments, recorded_levels(segments)),
                   synthesised = third_octave_levels(synthesis);
  return spectrum("Third-octave levels",
                  frequency_axis("Hz", 60, 16500, {63, 125, 250, 500, 1000, 2000, 4000, 8000, 16000}),
                  level_axis("dB re full scale", recorded, synthesised, 50), recorded, synthesised, sheet);
}

std::string modulation_panel(const Segments& segments, const std::vector<float>& synthesis,
                             const Sheet& sheet) {
  const BandLevels recorded = recorded_modulation(segments), synthesised = modulation_levels(synthesis);
  return spectrum("Envelope modulation",
                  frequency_axis("modulation frequency, Hz", 1, 260, {1, 2, 4, 8, 16, 32, 64, 128, 256}),
                  level_axis("dB re the mean", recorded, synthesised, 45), recorded, synthesised, sheet);
}

}  // namespace rigsound::analysis
