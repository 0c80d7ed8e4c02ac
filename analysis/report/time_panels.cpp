// Panels over time: spectrograms before, background, after; waveform and detected clicks.
#include <algorithm>

#include "chart/outline.hpp"
#include "chart/spectrum_palette.hpp"
#include "report/panels.hpp"
#include "report/spectrogram_image.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

using chart::Axis, chart::frequency_axis, chart::linear_axis, chart::Outline, chart::outline, chart::Role,
    chart::SvgPlot;

constexpr double kSpectrogramHeight = 150, kWaveformHeight = 200, kVerdictHeight = 110;
constexpr double kBarRoom = 66;  // right of the plane, for the colours

std::vector<float> beginning(const std::vector<float>& x, double seconds) {
  const auto count = std::min(x.size(), static_cast<std::size_t>(seconds * kAnalysisRate));
  return {x.begin(), x.begin() + static_cast<long>(count)};
}

std::string spectrogram(const char* title, const Axis& time, const std::vector<float>& x, double reference,
                        const Sheet& sheet) {
  SvgPlot plot(title, time,
               frequency_axis("Hz", kSpectrogramLowHz, kSpectrogramHighHz, {100, 300, 1000, 3000, 10000}),
               {sheet.full, kSpectrogramHeight, kBarRoom});
  plot->image(spectrogram_image(x, reference));
  plot->colour_bar({chart::kSpectrumPalette.begin(), chart::kSpectrumPalette.end()},
                   linear_axis("", -kSpectrogramRangeDb, 0, 3));
  plot->legend("dB re loudest", Role::kGrey);
  return plot.svg();
}

std::string waveform(const Axis& time, const ShownSegment& segment, const std::vector<float>& before,
                     const std::vector<float>& after, const Sheet& sheet) {
  const Outline recorded = outline(before.data(), before.size(), sheet.columns, time.low, 1 / kAnalysisRate),
                drilling = outline(after.data(), after.size(), sheet.columns, time.low, 1 / kAnalysisRate);
  SvgPlot plot("Detected clicks", time, linear_axis("of full scale", -recorded.peak, recorded.peak, 4),
               {sheet.full, kWaveformHeight, kBarRoom});
  plot->band(recorded.x, recorded.low, recorded.high, Role::kSecond);
  plot->band(drilling.x, drilling.low, drilling.high, Role::kFirst);
  std::vector<double> onsets;
  for (const int P : segment.chain.clicks.P)
    if (P < static_cast<int>(before.size())) onsets.push_back(time.low + P / kAnalysisRate);
  plot->verticals(onsets, {Role::kOnset, 0.8});
  plot->legend("recorded", Role::kGrey);
  plot->legend("drilling", Role::kFirst);
  plot->legend("onset", Role::kOnset);
  return plot.svg();
}

}  // namespace

std::string time_panels(const ShownSegment& segment, const Sheet& sheet) {
  const std::vector<float> before = beginning(segment.recorded, sheet.longest_s),
                           after = beginning(segment.drilling, sheet.longest_s);
  std::vector<float> background(before.size());
  for (std::size_t n = 0; n < before.size(); ++n) background[n] = before[n] - after[n];
  const double end_s = segment.start_s + static_cast<double>(before.size()) / kAnalysisRate;
  const Axis time = linear_axis("", segment.start_s, end_s, sheet.ticks);
  Axis labelled = time;
  labelled.label = "time in the recording, s";
  const double reference = spectrogram_peak(before);
  return spectrogram("Recording", time, before, reference, sheet) +
         spectrogram("Background, taken away", time, background, reference, sheet) +
         spectrogram("Drilling, what is left", time, after, reference, sheet) +
         waveform(labelled, segment, before, after, sheet);
}

std::string verdict_panel(const std::vector<VerdictWindow>& verdict, double start_s, const Sheet& sheet) {
  if (verdict.empty()) return {};
  const Axis time =
      linear_axis("time in the recording, s", start_s, start_s + verdict.back().end_s, sheet.ticks);
  SvgPlot plot("Probability of drilling", time, linear_axis("", 0, 1, 2),
               {sheet.full, kVerdictHeight, kBarRoom});
  std::vector<double> middle, probability;
  for (const VerdictWindow& window : verdict) {
    middle.push_back(start_s + (window.start_s + window.end_s) / 2);
    probability.push_back(window.probability);
  }
  plot->horizontal(kDrillingProbability, {Role::kGrey, 1});
  plot->line(middle, probability, {Role::kFirst, 1.5});
  plot->legend("of 2 s each", Role::kFirst);
  return plot.svg();
}

}  // namespace rigsound::analysis
