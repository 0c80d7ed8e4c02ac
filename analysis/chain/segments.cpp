#include "chain/segments.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "clicks/drilling_test.hpp"
#include "clicks/gaps.hpp"
#include "numeric/quantile.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kLongestClip = static_cast<long>(4 * kAnalysisRate);
constexpr long kCore = static_cast<long>(3 * kAnalysisRate);
constexpr long kSameClick = static_cast<long>(0.002 * kAnalysisRate);

/// Onsets of one segment in samples of the whole recording.
std::vector<long> onsets_of(const Segment& segment, const ChainResult& result) {
  std::vector<long> onsets;
  for (const int P : result.clicks.P) onsets.push_back(segment.begin + P);
  return onsets;
}

/// The time after which the right segment's clicks count: just behind the click both found that is nearest to
/// the middle of the overlap [begin, end), or the middle itself when they agree on none.
long seam(const std::vector<long>& left, const std::vector<long>& right, long begin, long end) {
  const long middle = (begin + end) / 2;
  long best = middle, distance = (end - begin) / 2;
  for (const long P : left) {
    if (P < begin || P >= end || std::labs(P - middle) >= distance) continue;
    const auto match = std::lower_bound(right.begin(), right.end(), P - kSameClick);
    if (match == right.end() || *match > P + kSameClick) continue;
    best = std::max(P, *match) + 1;
    distance = std::labs(P - middle);
  }
  return best;
}

/// Clicks first ... last - 1 of a segment.
struct Counted {
  std::size_t first = 0, last = 0;
};

/// Which clicks of each segment count.
std::vector<Counted> counted_clicks(const std::vector<Segment>& segments,
                                    const std::vector<ChainResult>& results) {
  std::vector<Counted> counted;
  long from = 0, before = std::numeric_limits<long>::min() / 2;  // the last click that counts so far
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const std::vector<long> here = onsets_of(segments[k], results[k]);
    const bool last = k + 1 == segments.size();
    const long to =
        last ? segments[k].end
             : seam(here, onsets_of(segments[k + 1], results[k + 1]), segments[k + 1].begin, segments[k].end);
    // Where the segments agree on no click, the same impact may still stand on both sides of the seam.
    const double closest = kShortestGap * results[k].clicks.mean_gap_samples;
    auto first = std::lower_bound(here.begin(), here.end(), from);
    const auto end = std::lower_bound(first, here.end(), to);
    while (first != end && static_cast<double>(*first - before) < closest) ++first;
    if (first != end) before = *std::prev(end);
    counted.push_back(
        {static_cast<std::size_t>(first - here.begin()), static_cast<std::size_t>(end - here.begin())});
    from = to;
  }
  return counted;
}

template <class Figure>
double median_over(const std::vector<DrillingSegment>& segments, Figure figure) {
  std::vector<double> values;
  for (const DrillingSegment& segment : segments) values.push_back(figure(segment.result.clicks));
  return upper_median(values);
}

ClickTrain join_clicks(const std::vector<DrillingSegment>& segments) {
  ClickTrain train;
  train.mean_gap_samples = median_over(segments, [](const ClickTrain& t) { return t.mean_gap_samples; });
  train.envelope.attack_samples =
      median_over(segments, [](const ClickTrain& t) { return t.envelope.attack_samples; });
  train.envelope.attack_bend =
      median_over(segments, [](const ClickTrain& t) { return t.envelope.attack_bend; });
  train.envelope.decay = median_over(segments, [](const ClickTrain& t) { return t.envelope.decay; });
  for (const DrillingSegment& segment : segments)
    for (std::size_t i = segment.first; i < segment.last; ++i) {
      train.P.push_back(static_cast<int>(segment.begin + segment.result.clicks.P[i]));
      train.beta.push_back(segment.result.clicks.beta[i]);
    }
  if (train.P.size() > 2) train.mean_gap_samples = median_gap(first_strikes(train.P));
  return train;
}

void accumulate(const std::vector<double>& psd, double weight, std::vector<double>& mean) {
  mean.resize(psd.size());
  for (size_t bin = 0; bin < psd.size(); ++bin) mean[bin] += weight * psd[bin];
}

std::vector<VerdictWindow> join_verdicts(const std::vector<Segment>& segments,
                                         const std::vector<ChainResult>& results) {
  std::vector<VerdictWindow> verdict;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const auto moved = [&](double s) {
      return static_cast<double>(segments[k].begin + std::lround(s * kAnalysisRate)) / kAnalysisRate;
    };
    for (const VerdictWindow& w : results[k].verdict)
      verdict.push_back({moved(w.start_s), moved(w.end_s), w.probability});
  }
  return verdict;
}

double highest_probability(const ChainResult& result) {
  double highest = 0;
  for (const VerdictWindow& w : result.verdict) highest = std::max(highest, w.probability);
  return highest;
}

const ChainResult& most_likely(const std::vector<ChainResult>& results) {
  return *std::max_element(results.begin(), results.end(), [](const ChainResult& a, const ChainResult& b) {
    return highest_probability(a) < highest_probability(b);
  });
}

/// All of a result but its clicks and its sound.
ChainResult join_powers(const std::vector<Segment>& segments, const std::vector<ChainResult>& results) {
  ChainResult joined;
  joined.drilling_found =
      std::any_of(results.begin(), results.end(), [](const auto& r) { return r.drilling_found; });
  joined.verdict = join_verdicts(segments, results);
  if (std::none_of(results.begin(), results.end(), [](const auto& r) { return r.reason.empty(); }))
    joined.reason = most_likely(results).reason;
  long total = 0;
  for (const Segment& segment : segments) total += segment.end - segment.begin;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const double weight =
        static_cast<double>(segments[k].end - segments[k].begin) / static_cast<double>(total);
    accumulate(results[k].signal_psd, weight, joined.signal_psd);
    accumulate(results[k].noise_psd, weight, joined.noise_psd);
    accumulate(results[k].output_psd, weight, joined.output_psd);
  }
  return joined;
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

void trust_the_label(std::vector<ChainResult>& results) {
  const bool sure =
      std::any_of(results.begin(), results.end(), [](const auto& r) { return r.drilling_found; });
  for (ChainResult& r : results) {
    if (!sure) r.drilling_found = r.clicks.P.size() >= kFewestDrillingClicks;
    if (!r.drilling_found) r.clicks = {};
  }
}

SegmentedResult join_segments(const std::vector<Segment>& segments, std::vector<ChainResult> results) {
  SegmentedResult whole;
  whole.segments = static_cast<int>(segments.size());
  if (results.size() == 1)
    whole.joined = results.front(), whole.joined.drilling = {};
  else
    whole.joined = join_powers(segments, results);
  const std::vector<Counted> counted = counted_clicks(segments, results);
  for (std::size_t k = 0; k < segments.size(); ++k)
    if (results[k].drilling_found)
      whole.drilling.push_back({segments[k].begin, counted[k].first, counted[k].last, std::move(results[k])});
  if (segments.size() > 1 && !whole.drilling.empty()) whole.joined.clicks = join_clicks(whole.drilling);
  return whole;
}

std::vector<float> join_drilling(const std::vector<Segment>& segments,
                                 const std::vector<ChainResult>& results) {
  std::vector<float> whole(static_cast<size_t>(segments.back().end));
  for (size_t k = 0; k < segments.size(); ++k) {
    const long rise_end = k > 0 ? segments[k - 1].end : 0;
    const long fall_begin = k + 1 < segments.size() ? segments[k + 1].begin : segments[k].end;
    if (results[k].drilling.size() == 0) continue;  // nothing of this machine
    const std::vector<float> drilling = results[k].drilling.all();
    for (long n = segments[k].begin; n < segments[k].end; ++n) {
      float weight = 1;
      if (n < rise_end)
        weight = static_cast<float>(n - segments[k].begin) / static_cast<float>(rise_end - segments[k].begin);
      if (n >= fall_begin)
        weight = static_cast<float>(segments[k].end - n) / static_cast<float>(segments[k].end - fall_begin);
      whole[n] += weight * drilling[n - segments[k].begin];
    }
  }
  return whole;
}

}  // namespace rigsound::analysis
