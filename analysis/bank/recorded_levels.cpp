#include "bank/recorded_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clicks/gaps.hpp"
#include "rigsound/analysis/rate.hpp"
#include "rigsound/dsp/energy.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kMaxGivenBackDb = 9, kMinSnrDb = -10;
constexpr double kLowestHz = 200;    // below, a band is narrower than two bins of the model
constexpr double kPausePeriods = 3;  // a longer gap is a pause, not a missed impact

std::vector<double> summed(const Segments& segments, std::vector<double> ChainResult::*psd) {
  std::vector<double> sum;
  for (const DrillingSegment& s : segments) {
    const std::vector<double>& values = s.result.*psd;
    sum.resize(std::max(sum.size(), values.size()), 0.0);
    for (std::size_t k = 0; k < values.size(); ++k)
      sum[k] += values[k] * static_cast<double>(s.result.drilling.size());
  }
  return sum;
}

/// Sum over the third-octave band around `centre_hz` of a one-sided power spectrum.
double in_band(const std::vector<double>& psd, double centre_hz) {
  const double step = kAnalysisRate / 2 / static_cast<double>(psd.size() - 1), edge = std::pow(2.0, 1.0 / 6);
  double sum = 0;
  for (std::size_t k = 0; k < psd.size(); ++k) {
    const double f = static_cast<double>(k) * step;
    if (f >= centre_hz / edge && f < centre_hz * edge) sum += psd[k];
  }
  return sum;
}

std::vector<float> first_to_last_click(const DrillingSegment& s) {
  const std::vector<int> P = own_onsets(s);
  return s.result.drilling.piece(static_cast<std::size_t>(P.front()), static_cast<std::size_t>(P.back()));
}

}  // namespace

BandLevels recorded_levels(const Segments& segments) {
  BandLevels mean;
  double total = 0;
  for (const DrillingSegment& s : segments) {
    const std::vector<float> drilled = first_to_last_click(s);
    const BandLevels here = third_octave_levels(drilled);
    const auto weight = static_cast<double>(drilled.size());
    mean.centre_hz = here.centre_hz;
    mean.level_db.resize(here.level_db.size(), 0.0);
    for (std::size_t b = 0; b < here.level_db.size(); ++b)
      mean.level_db[b] += weight * std::pow(10, here.level_db[b] / 10);
    total += weight;
  }
  for (double& level : mean.level_db) level = 10 * std::log10(level / total);
  return mean;
}

BandLevels given_back(const Segments& segments, BandLevels levels) {
  const std::vector<double> S = summed(segments, &ChainResult::signal_psd),
                            N = summed(segments, &ChainResult::noise_psd),
                            G = summed(segments, &ChainResult::output_psd);
  if (S.size() < 2 || N.size() != S.size() || G.size() != S.size()) return levels;  // taken as clean
  for (std::size_t b = 0; b < levels.centre_hz.size(); ++b) {
    const double f = levels.centre_hz[b], s = in_band(S, f), n = in_band(N, f), g = in_band(G, f);
    if (f < kLowestHz || !(s > 0) || !(g > 0) || 10 * std::log10(s / std::max(n, 1e-30)) < kMinSnrDb)
      continue;
    levels.level_db[b] += std::clamp(10 * std::log10(s / g), 0.0, kMaxGivenBackDb);
  }
  return levels;
}

BandLevels recorded_modulation(const Segments& segments) {
  std::vector<float> longest;
  for (const DrillingSegment& s : segments) {
    std::vector<float> drilled = first_to_last_click(s);
    if (drilled.size() > longest.size()) longest = std::move(drilled);
  }
  return modulation_levels(longest);
}

double drilling_power(const Segments& segments) {
  double drilled = 0, sum = 0;
  for (const DrillingSegment& s : segments) {
    const std::vector<int> P = own_onsets(s);
    const double longest = kPausePeriods * median_gap(P);
    const std::vector<float> drilling = s.result.drilling.all();
    for (std::size_t i = 1; i < P.size(); ++i) {
      if (P[i] - P[i - 1] >= longest) continue;
      drilled += P[i] - P[i - 1];
      sum += dsp::energy(drilling.data() + P[i - 1], static_cast<std::size_t>(P[i] - P[i - 1]));
    }
  }
  return sum / drilled;
}

double signal_to_noise_db(const Segments& segments) {
  const std::vector<double> S = summed(segments, &ChainResult::signal_psd),
                            N = summed(segments, &ChainResult::noise_psd);
  double s = 0, n = 0;
  for (const double v : S) s += v;
  for (const double v : N) n += v;
  return n > 0 ? 10 * std::log10(s / n) : std::numeric_limits<double>::infinity();
}

}  // namespace rigsound::analysis
