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

constexpr double kLongest_s = 2;
constexpr std::size_t kColumns = 720;
constexpr chart::PlotSize kSpectrogramSize{1200, 150, 66}, kWaveformSize{1200, 200, 66};

std::vector<float> beginning(const std::vector<float>& x) {
  const auto count = std::min(x.size(), static_cast<std::size_t>(kLongest_s * kAnalysisRate));
  return {x.begin(), x.begin() + static_cast<long>(count)};
}

std::string spectrogram(const char* title, const Axis& time, const std::vector<float>& x, double reference) {
  SvgPlot plot(title, time,
               frequency_axis("Hz", kSpectrogramLowHz, kSpectrogramHighHz, {100, 300, 1000, 3000, 10000}),
               kSpectrogramSize);
  plot->image(spectrogram_image(x, reference));
  plot->colour_bar({chart::kSpectrumPalette.begin(), chart::kSpectrumPalette.end()},
                   linear_axis("", -kSpectrogramRangeDb, 0, 3));
  plot->legend("dB re the loudest", Role::kGrey);
  return plot.svg();
}

std::string waveform(const Axis& time, const ShownSegment& segment, const std::vector<float>& before,
                     const std::vector<float>& after) {
  const Outline recorded = outline(before.data(), before.size(), kColumns, time.low, 1 / kAnalysisRate),
                drilling = outline(after.data(), after.size(), kColumns, time.low, 1 / kAnalysisRate);
  SvgPlot plot("Detected clicks", time, linear_axis("of full scale", -recorded.peak, recorded.peak, 4),
               kWaveformSize);
  plot->band(recorded.x, recorded.low, recorded.high, Role::kSecond);
  plot->band(drilling.x, drilling.low, drilling.high, Role::kFirst);
  std::vector<double> onsets;
  for (const int P : segment.chain.clicks.P)
    if (P < static_cast<int>(before.size())) onsets.push_back(time.low + P / kAnalysisRate);
  plot->verticals(onsets, {Role::kOnset, 0.8});
  plot->legend("recording", Role::kGrey);
  plot->legend("drilling", Role::kFirst);
  plot->legend("detected onset", Role::kOnset);
  return plot.svg();
}

}  // namespace

std::string time_panels(const ShownSegment& segment) {
  const std::vector<float> before = beginning(segment.recorded), after = beginning(segment.chain.drilling);
  std::vector<float> background(before.size());
  for (std::size_t n = 0; n < before.size(); ++n) background[n] = before[n] - after[n];
  const double end_s = segment.start_s + static_cast<double>(before.size()) / kAnalysisRate;
  const Axis time = linear_axis("", segment.start_s, end_s, 10);
  Axis labelled = time;
  labelled.label = "time in the recording, s";
  const double reference = spectrogram_peak(before);
  return spectrogram("Recording", time, before, reference) +
         spectrogram("Background, taken away", time, background, reference) +
         spectrogram("Drilling, what is left", time, after, reference) +
         waveform(labelled, segment, before, after);
}

}  // namespace rigsound::analysis
