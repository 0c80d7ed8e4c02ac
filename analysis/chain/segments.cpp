#include "chain/segments.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kLongestClip = static_cast<long>(4 * kAnalysisRate);
constexpr long kCore = static_cast<long>(3 * kAnalysisRate);
constexpr long kSameClick = static_cast<long>(0.002 * kAnalysisRate);

/// Clicks of one segment in samples of the whole recording.
struct Placed {
  std::vector<long> P;
  std::vector<double> beta;
};

Placed place(const Segment& segment, const ChainResult& result) {
  Placed placed;
  for (const int P : result.clicks.P) placed.P.push_back(segment.begin + P);
  placed.beta = result.clicks.beta;
  return placed;
}

/// The time after which the right segment's clicks count: just behind the click both found that is nearest to
/// the middle of the overlap [begin, end), or the middle itself when they agree on none.
long seam(const Placed& left, const Placed& right, long begin, long end) {
  const long middle = (begin + end) / 2;
  long best = middle, distance = (end - begin) / 2;
  for (const long P : left.P) {
    if (P < begin || P >= end || std::labs(P - middle) >= distance) continue;
    const auto match = std::lower_bound(right.P.begin(), right.P.end(), P - kSameClick);
    if (match == right.P.end() || *match > P + kSameClick) continue;
    best = std::max(P, *match) + 1;
    distance = std::labs(P - middle);
  }
  return best;
}

void append(const Placed& from, long begin, long end, double closest, ClickTrain& train) {
  for (size_t i = 0; i < from.P.size(); ++i) {
    if (from.P[i] < begin || from.P[i] >= end) continue;
    // Where the segments agree on no click, the same strike may still stand on both sides of the seam.
    if (!train.P.empty() && static_cast<double>(from.P[i] - train.P.back()) < closest) continue;
    train.P.push_back(static_cast<int>(from.P[i]));
    train.beta.push_back(from.beta[i]);
  }
}

template <class Figure>
double median_over(const std::vector<ChainResult>& results, Figure figure) {
  std::vector<double> values;
  for (const ChainResult& result : results)
    if (result.drilling_found) values.push_back(figure(result.clicks));
  return median(values);
}

ClickTrain join_clicks(const std::vector<Segment>& segments, const std::vector<ChainResult>& results) {
  ClickTrain train;
  train.mean_gap_samples = median_over(results, [](const ClickTrain& t) { return t.mean_gap_samples; });
  train.envelope.attack_samples =
      median_over(results, [](const ClickTrain& t) { return t.envelope.attack_samples; });
  train.envelope.attack_bend =
      median_over(results, [](const ClickTrain& t) { return t.envelope.attack_bend; });
  train.envelope.decay = median_over(results, [](const ClickTrain& t) { return t.envelope.decay; });
  long from = 0;
  for (size_t k = 0; k < segments.size(); ++k) {
    const Placed here = place(segments[k], results[k]);
    const bool last = k + 1 == segments.size();
    const long to =
        last ? segments[k].end
             : seam(here, place(segments[k + 1], results[k + 1]), segments[k + 1].begin, segments[k].end);
    append(here, from, to, kShortestGap * results[k].clicks.mean_gap_samples, train);
    from = to;
  }
  if (train.P.size() > 2) train.mean_gap_samples = median_gap(train.P);
  return train;
}

/// Linear ramps that sum to 1 over an overlap: both sides hold the same sound.
std::vector<float> join_drilling(const std::vector<Segment>& segments,
                                 const std::vector<ChainResult>& results) {
  std::vector<float> whole(static_cast<size_t>(segments.back().end));
  for (size_t k = 0; k < segments.size(); ++k) {
    const long rise_end = k > 0 ? segments[k - 1].end : 0;
    const long fall_begin = k + 1 < segments.size() ? segments[k + 1].begin : segments[k].end;
    for (long n = segments[k].begin; n < segments[k].end; ++n) {
      float weight = 1;
      if (n < rise_end)
        weight = static_cast<float>(n - segments[k].begin) / static_cast<float>(rise_end - segments[k].begin);
      if (n >= fall_begin)
        weight = static_cast<float>(segments[k].end - n) / static_cast<float>(segments[k].end - fall_begin);
      whole[n] += weight * results[k].drilling[n - segments[k].begin];
    }
  }
  return whole;
}

void accumulate(const std::vector<double>& psd, double weight, std::vector<double>& mean) {
  mean.resize(psd.size());
  for (size_t bin = 0; bin < psd.size(); ++bin) mean[bin] += weight * psd[bin];
}

}  // namespace

std::vector<Segment> plan_segments(long length) {
  if (length <= kLongestClip) return {{0, length}};
  const long count = (length + kCore - 1) / kCore;
  std::vector<Segment> segments;
  for (long k = 0; k < count; ++k)
    segments.push_back({std::max(0L, k * length / count - kSegmentOverlap / 2),
                        std::min(length, (k + 1) * length / count + kSegmentOverlap / 2)});
  return segments;
}

ChainResult join_segments(const std::vector<Segment>& segments, const std::vector<ChainResult>& results) {
  if (results.size() == 1) return results.front();
  ChainResult joined;
  joined.drilling_found =
      std::any_of(results.begin(), results.end(), [](const auto& r) { return r.drilling_found; });
  if (joined.drilling_found)
    joined.clicks = join_clicks(segments, results);
  else
    joined.reason = results.front().reason;
  joined.drilling = join_drilling(segments, results);
  long total = 0;
  for (const Segment& segment : segments) total += segment.end - segment.begin;
  for (size_t k = 0; k < segments.size(); ++k) {
    const double weight =
        static_cast<double>(segments[k].end - segments[k].begin) / static_cast<double>(total);
    accumulate(results[k].signal_psd, weight, joined.signal_psd);
    accumulate(results[k].noise_psd, weight, joined.noise_psd);
    accumulate(results[k].output_psd, weight, joined.output_psd);
  }
  return joined;
}

}  // namespace rigsound::analysis
