#include <algorithm>
#include <cmath>

#include "annotate/change_points.hpp"
#include "annotate/features.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/suggestions.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kBlock = 5, kShortest = 6;  // frames: half a second and a little more
constexpr double kLevelFloor_db = 1.2, kRateFloor = 0.04;
constexpr double kPenaltyFactor = 1.5;
constexpr double kChangedLevel_db = 1.5, kChangedSpectrum_db = 1.5, kChangedRate = 0.03;

/// Rows of the series: band levels, then the logarithm of the rate, where there is none the median one: that
/// impacts begin is told by the levels.
Eigen::ArrayXXd series_of(const Features& features) {
  std::vector<double> known;
  for (const double hz : features.rate_hz)
    if (hz > 0) known.push_back(std::log(hz));
  const double middle = known.empty() ? 0 : upper_median(known);
  Eigen::ArrayXXd series(kFeatureBands + 1, features.frames());
  series.topRows(kFeatureBands) = features.levels;
  for (long f = 0; f < features.frames(); ++f) {
    const double hz = features.rate_hz[static_cast<std::size_t>(f)];
    series(kFeatureBands, f) = hz > 0 ? std::log(hz) : middle;
  }
  return series;
}

/// One part as it is, without what changed at its start.
struct Described {
  SuggestedPart part;
  Eigen::ArrayXd levels;
};

Described described(const Features& features, long from, long to) {
  Described d;
  d.levels = features.levels.middleCols(from, to - from).rowwise().mean();
  double power = 0;
  for (long b = 0; b < kFeatureBands; ++b) power += std::pow(10, d.levels[b] / 10);
  std::vector<double> rates;
  for (long f = from; f < to; ++f)
    if (const double hz = features.rate_hz[static_cast<std::size_t>(f)]; hz > 0) rates.push_back(hz);
  d.part.start_s = features.hop_s * static_cast<double>(from);
  d.part.end_s = features.hop_s * static_cast<double>(to);
  d.part.level_db = 10 * std::log10(power);
  d.part.rhythmic = static_cast<double>(rates.size()) / static_cast<double>(to - from);
  if (d.part.rhythmic >= 0.5) d.part.rate_hz = upper_median(rates);
  return d;
}

void say_what_changed(const Described& before, Described& now) {
  const Eigen::ArrayXd step = now.levels - before.levels;
  const double level = now.part.level_db - before.part.level_db;
  now.part.level_changed = std::fabs(level) > kChangedLevel_db;
  now.part.spectrum_changed = std::sqrt((step - step.mean()).square().mean()) > kChangedSpectrum_db;
  const double a = before.part.rate_hz, b = now.part.rate_hz;
  now.part.rate_changed = (a > 0) != (b > 0) || (a > 0 && std::fabs(std::log(b / a)) > kChangedRate);
}

}  // namespace

std::vector<SuggestedPart> suggest_parts(SoundReader& sound, const Progress& progress) {
  const Features features = features_of(sound, progress);
  const Eigen::ArrayXXd series = series_of(features);
  Eigen::ArrayXd floor = Eigen::ArrayXd::Constant(kFeatureBands + 1, kLevelFloor_db);
  floor[kFeatureBands] = kRateFloor;
  const Eigen::ArrayXXd white = (whitening_of(series, kBlock, floor) * series.matrix()).array();
  const double n = static_cast<double>(features.frames()),
               penalty = kPenaltyFactor * static_cast<double>(series.rows() + 1) * std::log(std::max(n, 2.0));
  const std::vector<ChangePoint> changes = change_points(white, penalty, kShortest, [&](long t) {
    if (progress && t % 64 == 0) progress(0.95 + 0.05 * static_cast<double>(t) / n);
  });
  std::vector<Described> parts;
  long from = 0;
  for (std::size_t i = 0; i <= changes.size(); ++i) {
    const long to = i < changes.size() ? changes[i].first : features.frames();
    parts.push_back(described(features, from, to));
    if (i > 0) {
      say_what_changed(parts[i - 1], parts[i]);
      parts[i].part.confidence = std::clamp(1 - penalty / changes[i - 1].gain, 0.0, 1.0);
    }
    from = to;
  }
  parts.back().part.end_s = sound.shape().seconds();
  std::vector<SuggestedPart> suggested;
  for (const Described& d : parts) suggested.push_back(d.part);
  return suggested;
}

}  // namespace rigsound::analysis
