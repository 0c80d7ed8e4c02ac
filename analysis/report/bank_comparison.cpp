#include "rigsound/analysis/bank_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "bank/candidates.hpp"
#include "bank/recorded_levels.hpp"
#include "report/measured_clicks.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/elementary.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::analysis {
namespace {

constexpr int kBins = 30;

/// Density of the lognormal with that mean and standard deviation.
double lognormal_density(double v, double mean, double deviation) {
  const double s2 = std::log1p(deviation * deviation / (mean * mean)), mu = std::log(mean) - 0.5 * s2;
  const double z = (std::log(v) - mu) / std::sqrt(s2);
  return std::exp(-0.5 * z * z) / (v * std::sqrt(dsp::kTwoPi * s2));
}

Histogram histogram_of(const std::vector<double>& values, double mean, double deviation) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double from = 0.9 * *low, to = 1.1 * *high, width = (to - from) / kBins;
  Histogram histogram;
  histogram.share.assign(kBins, 0.0);
  for (int b = 0; b <= kBins; ++b) histogram.edges.push_back(from + b * width);
  for (const double v : values)
    histogram.share[std::min(static_cast<std::size_t>((v - from) / width), histogram.share.size() - 1)] +=
        1 / static_cast<double>(values.size());
  for (int i = 0; i <= 4 * kBins; ++i) {
    histogram.engine.x.push_back(from + i * width / 4);
    histogram.engine.y.push_back(
        deviation > 1e-6 * mean ? width * lognormal_density(histogram.engine.x.back(), mean, deviation) : 0);
  }
  return histogram;
}

Curve curve_of(const BandLevels& levels) { return {levels.centre_hz, levels.level_db}; }

}  // namespace

std::vector<double> gaps_ms(const Segments& segments) {
  std::vector<double> gaps;
  for (const DrillingSegment& s : segments) {
    const std::vector<int> P = own_onsets(s);
    for (std::size_t i = 1; i < P.size(); ++i) gaps.push_back(1e3 * (P[i] - P[i - 1]) / kAnalysisRate);
  }
  return gaps;
}

std::vector<double> amplitudes_over_mean(const Segments& segments) {
  std::vector<double> norms;
  double mean = 0;
  for (const ClickCandidate& c : click_candidates(segments)) norms.push_back(c.norm);
  for (const double v : norms) mean += v / static_cast<double>(norms.size());
  for (double& v : norms) v /= mean;
  return norms;
}

SoundSpectra spectra_of(const std::vector<float>& sound) {
  return {curve_of(third_octave_levels(sound)), curve_of(modulation_levels(sound))};
}

RecordedSide recorded_side(std::vector<float> recorded, const ChainOptions& chain, const std::string& part) {
  const SegmentedResult result = run_chain_in_memory(recorded, chain);
  const Segments segments = learnable(result.drilling);
  if (segments.empty()) throw InputError(part, "no drilling is found in it any more");
  RecordedSide side;
  side.of_recorded = spectra_of(recorded);
  const BandLevels levels = recorded_levels(segments);
  side.of_denoised = {curve_of(levels), curve_of(recorded_modulation(segments))};
  side.target = curve_of(given_back(segments, levels));
  side.gaps_ms = gaps_ms(segments);
  side.amplitudes = amplitudes_over_mean(segments);
  side.denoised = result.joined.drilling.all();
  side.recorded = std::move(recorded);
  return side;
}

Histogram gap_histogram(const std::vector<double>& gaps, const ClickBank& bank) {
  return histogram_of(gaps, 1e3 * bank.mean_gap_samples / bank.sample_rate,
                      1e3 * bank.gap_deviation_samples / bank.sample_rate);
}

Histogram amplitude_histogram(const std::vector<double>& amplitudes, const ClickBank& bank) {
  return histogram_of(amplitudes, 1, bank.amplitude_deviation / bank.mean_amplitude);
}

}  // namespace rigsound::analysis
