// Panels that show figures: histograms and spectra.
#include <algorithm>
#include <cmath>

#include "bank/candidates.hpp"
#include "bank/recorded_levels.hpp"
#include "chart/svg_plot.hpp"
#include "report/panels.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"

namespace rigsound::analysis {
namespace {

using chart::Axis, chart::frequency_axis, chart::linear_axis, chart::Role, chart::SvgPlot;

constexpr int kBins = 30;

/// Density of the lognormal with that mean and standard deviation.
double lognormal_density(double v, double mean, double deviation) {
  const double s2 = std::log1p(deviation * deviation / (mean * mean)), mu = std::log(mean) - 0.5 * s2;
  const double z = (std::log(v) - mu) / std::sqrt(s2);
  return std::exp(-0.5 * z * z) / (v * std::sqrt(dsp::kTwoPi * s2));
}

/// Histogram of `values` with the lognormal the engine draws from.
std::string histogram(const char* title, const char* unit, const std::vector<double>& values, double mean,
                      double deviation) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = 0.9 * *low, to = 1.1 * *high, width = (to - from) / kBins;
  std::vector<double> edges, share(kBins, 0.0), x, y;
  for (int b = 0; b <= kBins; ++b) edges.push_back(from + b * width);
  for (const double v : values)
    share[std::min(static_cast<std::size_t>((v - from) / width), share.size() - 1)] +=
        1 / static_cast<double>(values.size());
  for (int i = 0; i <= 4 * kBins; ++i) {
    x.push_back(from + i * width / 4);
    y.push_back(deviation > 1e-6 * mean ? width * lognormal_density(x.back(), mean, deviation) : 0);
  }
  const double top = 1.1 * *std::max_element(share.begin(), share.end());
  SvgPlot plot(title, linear_axis(unit, from, to), linear_axis("share of clicks", 0, top, 4), kThird);
  plot->bars(edges, share, Role::kFirst);
  plot->line(x, y, {Role::kThird, 1.6});
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
  std::vector<double> gaps;
  for (const DrillingSegment& s : segments) {
    const std::vector<int> P = own_onsets(s);
    for (std::size_t i = 1; i < P.size(); ++i) gaps.push_back(1e3 * (P[i] - P[i - 1]) / kAnalysisRate);
  }
  return histogram("Gaps between clicks", "ms", gaps, 1e3 * bank.mean_gap_samples / bank.sample_rate,
                   1e3 * bank.gap_deviation_samples / bank.sample_rate);
}

std::string amplitude_panel(const Segments& segments, const ClickBank& bank) {
  std::vector<double> norms;
  double mean = 0;
  for (const ClickCandidate& c : click_candidates(segments)) norms.push_back(c.norm);
  for (const double v : norms) mean += v / static_cast<double>(norms.size());
  for (double& v : norms) v /= mean;
  return histogram("Amplitudes of clicks", "over their mean", norms, 1,
                   bank.amplitude_deviation / bank.mean_amplitude);
}

std::string third_octave_panel(const Segments& segments, const std::vector<float>& synthesis,
                               const Sheet& sheet) {
  const BandLevels recorded = recorded_levels(segments, Levels::kGivenBack),
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
