// Panels that show samples: spectrograms, waveform, envelope, clicks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "clicks/envelope.hpp"
#include "clicks/gaps.hpp"
#include "report/panels.hpp"
#include "report/plot.hpp"
#include "report/spectrogram_image.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kWaveformSeconds = 1;
constexpr int kWaveformColumns = 600, kClickColumns = 110;
constexpr double kEnvelopeRangeDb = 50;
constexpr int kEnvelopeBlock = 24;  // samples, half a millisecond

/// Lowest and highest sample of each column.
struct Outline {
  std::vector<double> x, low, high;
};

Outline outline(const float* samples, std::size_t count, int columns, double seconds_per_sample) {
  Outline o;
  for (int c = 0; c < columns; ++c) {
    const std::size_t from = count * c / columns, to = std::max(from + 1, count * (c + 1) / columns);
    if (to > count) break;
    const auto [low, high] = std::minmax_element(samples + from, samples + to);
    o.x.push_back(static_cast<double>(from) * seconds_per_sample);
    o.low.push_back(*low);
    o.high.push_back(*high);
  }
  return o;
}

double peak(const float* samples, std::size_t count) {
  double p = 1e-9;
  for (std::size_t n = 0; n < count; ++n) p = std::max(p, std::fabs(static_cast<double>(samples[n])));
  return p;
}

/// RMS of the drilling in blocks after an onset, over all clicks, up to one period.
std::vector<double> mean_course_db(const ChainResult& s) {
  const auto blocks = static_cast<std::size_t>(median_gap(s.clicks.P) / kEnvelopeBlock);
  std::vector<double> power(blocks, 0.0);
  for (const int P : s.clicks.P)
    for (std::size_t n = 0; n < blocks * kEnvelopeBlock; ++n) {
      if (P + n >= s.drilling.size()) break;
      power[n / kEnvelopeBlock] += static_cast<double>(s.drilling[P + n]) * s.drilling[P + n];
    }
  const double loudest = *std::max_element(power.begin(), power.end());
  for (double& p : power) p = 10 * std::log10(std::max(p / loudest, 1e-9));
  return power;
}

/// What the fitted train predicts for the same blocks: its own click and the tails of those before.
std::vector<double> fitted_course_db(const ClickEnvelope& shape, double period, std::size_t blocks) {
  constexpr int kTails = 6;
  std::vector<double> power(blocks, 0.0);
  for (std::size_t n = 0; n < blocks * kEnvelopeBlock; ++n)
    for (int k = 0; k <= kTails; ++k) {
      const double a = envelope(shape, static_cast<double>(n) + k * period);
      power[n / kEnvelopeBlock] += a * a;
    }
  const double loudest = *std::max_element(power.begin(), power.end());
  for (double& p : power) p = 10 * std::log10(std::max(p / loudest, 1e-9));
  return power;
}

}  // namespace

std::string spectrogram_panels(const std::vector<float>& recorded, const ChainResult& segment) {
  std::vector<float> background(recorded.size());
  for (std::size_t n = 0; n < recorded.size(); ++n) background[n] = recorded[n] - segment.drilling[n];
  const double reference = spectrogram_peak(recorded),
               seconds = static_cast<double>(recorded.size()) / kAnalysisRate;
  std::string html;
  const auto add = [&](const char* title, const std::vector<float>& x) {
    Plot plot(title, linear_axis("s", 0, seconds),
              frequency_axis("Hz", kSpectrogramLowHz, kSpectrogramHighHz, {100, 300, 1000, 3000, 10000}));
    plot.image(spectrogram_image(x, reference));
    html += plot.svg();
  };
  add("Recording", recorded);
  add("Background, taken away", background);
  add("Drilling, what is left", segment.drilling);
  return html;
}

std::string waveform_panel(const std::vector<float>& recorded, const ChainResult& segment) {
  const auto count = std::min(recorded.size(), static_cast<std::size_t>(kWaveformSeconds * kAnalysisRate));
  const double seconds = static_cast<double>(count) / kAnalysisRate, top = peak(recorded.data(), count);
  Plot plot("Detected clicks", linear_axis("s", 0, seconds, 10), linear_axis("amplitude", -top, top, 4), 860,
            190);
  const Outline before = outline(recorded.data(), count, kWaveformColumns, 1 / kAnalysisRate);
  const Outline after = outline(segment.drilling.data(), count, kWaveformColumns, 1 / kAnalysisRate);
  plot.area(before.x, before.low, before.high, "second");
  plot.area(after.x, after.low, after.high, "first");
  std::vector<double> onsets;
  for (const int P : segment.clicks.P)
    if (P < static_cast<int>(count)) onsets.push_back(P / kAnalysisRate);
  plot.verticals(onsets, "onset");
  plot.legend("recording", "second");
  plot.legend("drilling", "first");
  plot.legend("onset", "onset");
  return plot.svg();
}

std::string envelope_panel(const ChainResult& segment) {
  const std::vector<double> mean = mean_course_db(segment);
  const double period = median_gap(segment.clicks.P);
  const std::vector<double> fit = fitted_course_db(segment.clicks.envelope, period, mean.size());
  std::vector<double> ms;
  for (std::size_t b = 0; b < mean.size(); ++b)
    ms.push_back(1e3 * static_cast<double>(b) * kEnvelopeBlock / kAnalysisRate);
  const double range = std::min(kEnvelopeRangeDb, 5 - *std::min_element(mean.begin(), mean.end()));
  Plot plot("Envelope", linear_axis("ms after the onset", 0, 1e3 * period / kAnalysisRate),
            linear_axis("dB", -range, 0));
  plot.line(ms, mean, "first");
  plot.line(ms, fit, "third");
  plot.legend("mean over clicks", "first");
  plot.legend("fitted", "third");
  return plot.svg();
}

std::string click_panels(const ClickBank& bank) {
  std::string html;
  for (std::size_t i = 0; i < bank.clicks.size(); ++i) {
    const std::vector<float>& click = bank.clicks[i];
    const double ms = 1e3 * static_cast<double>(click.size()) / bank.sample_rate,
                 top = peak(click.data(), click.size());
    Plot plot(fmt::format("Click {}", i + 1), linear_axis("ms", 0, ms, 3), linear_axis("", -top, top, 2), 200,
              110);
    const Outline shape = outline(click.data(), click.size(), kClickColumns, 1e3 / bank.sample_rate);
    plot.area(shape.x, shape.low, shape.high, "first");
    html += plot.svg();
  }
  return html;
}

}  // namespace rigsound::analysis
