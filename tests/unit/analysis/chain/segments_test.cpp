#include "chain/segments.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "bank/segment.hpp"
#include "rigsound/analysis/parallel.hpp"

using namespace rigsound::analysis;

namespace {

/// What a perfect analysis of [begin, end) would give for clicks every `period` samples and sound x_n = n.
ChainResult perfect(const Segment& segment, long period, long error) {
  ChainResult result;
  result.drilling_found = true;
  result.clicks.mean_gap_samples = double(period);
  result.clicks.envelope = {40, 0, 0.001};
  for (long P = 500; P < segment.end; P += period)
    if (P >= segment.begin)
      result.clicks.P.push_back(int(P - segment.begin + error)), result.clicks.beta.push_back(1);
  std::vector<float> sound;
  for (long n = segment.begin; n < segment.end; ++n) sound.push_back(float(n));
  result.drilling = sound;
  result.signal_psd = result.noise_psd = result.output_psd = std::vector<double>(257, 2.0);
  return result;
}

}  // namespace

TEST_CASE("segments cover the recording, overlap, and last two to four seconds") {
  CHECK(plan_segments(4 * 48000).size() == 1);
  for (const long length : {4L * 48000 + 1, 7L * 48000, 600L * 48000 + 17}) {
    const std::vector<Segment> segments = plan_segments(length);
    CHECK(segments.front().begin == 0);
    CHECK(segments.back().end == length);
    for (size_t k = 0; k < segments.size(); ++k) {
      CHECK(segments[k].end - segments[k].begin >= 2 * 48000);
      CHECK(segments[k].end - segments[k].begin <= 4 * 48000);
      if (k > 0) CHECK(segments[k - 1].end - segments[k].begin == kSegmentOverlap);
    }
  }
}

TEST_CASE("no click is lost or doubled at a seam, whatever the period and the segments' small disagreement") {
  const std::vector<Segment> segments = plan_segments(11 * 48000);
  for (const long period : {800L, 1531L, 2667L, 4000L, 9000L})
    for (const long error : {0L, 30L, -30L}) {
      std::vector<ChainResult> results;
      for (size_t k = 0; k < segments.size(); ++k)
        results.push_back(perfect(segments[k], period, k % 2 ? error : 0));
      const ChainResult joined = join_segments(segments, results).joined;
      CHECK(joined.clicks.P.size() == size_t((11 * 48000 - 500 + period - 1) / period));
      for (size_t i = 1; i < joined.clicks.P.size(); ++i)
        CHECK(std::labs(joined.clicks.P[i] - joined.clicks.P[i - 1] - period) <= std::labs(error));
    }
}

TEST_CASE("every click counts in one segment, and every gap is known to one") {
  const std::vector<Segment> segments = plan_segments(11 * 48000);
  std::vector<ChainResult> results;
  for (const Segment& segment : segments) results.push_back(perfect(segment, 1531, 0));
  const SegmentedResult whole = join_segments(segments, results);
  REQUIRE(whole.drilling.size() == segments.size());
  CHECK(whole.segments == int(segments.size()));
  std::vector<long> counted;
  size_t gaps = 0;
  for (const DrillingSegment& segment : whole.drilling) {
    for (size_t i = segment.first; i < segment.last; ++i)
      counted.push_back(segment.begin + segment.result.clicks.P[i]);
    const std::vector<int> onsets = own_onsets(segment);
    for (size_t i = 1; i < onsets.size(); ++i) CHECK(onsets[i] - onsets[i - 1] == 1531);
    gaps += onsets.size() - 1;
  }
  CHECK(counted == std::vector<long>(whole.joined.clicks.P.begin(), whole.joined.clicks.P.end()));
  CHECK(gaps == counted.size() - 1);
}

TEST_CASE("sound that the segments agree on passes the crossfades unchanged") {
  const std::vector<Segment> segments = plan_segments(9 * 48000);
  std::vector<ChainResult> results;
  for (const Segment& segment : segments) results.push_back(perfect(segment, 1600, 0));
  const std::vector<float> drilling = join_drilling(segments, results);
  REQUIRE(drilling.size() == 9 * 48000);
  double error = 0;
  for (size_t n = 0; n < drilling.size(); ++n)
    error = std::max(error, std::fabs(double(drilling[n]) - double(n)));
  CHECK(error < 0.1);
  CHECK(join_segments(segments, results).joined.signal_psd[7] == doctest::Approx(2));
}

TEST_CASE("drilling in one segment is drilling, in none it is not, and the reason stays") {
  const std::vector<Segment> segments = plan_segments(9 * 48000);
  std::vector<ChainResult> results;
  for (const Segment& segment : segments) {
    results.push_back(perfect(segment, 1600, 0));
    results.back().drilling_found = false;
    results.back().clicks = {};
    results.back().reason = "quiet";
  }
  ChainResult joined = join_segments(segments, results).joined;
  CHECK(!joined.drilling_found);
  CHECK(joined.reason == "quiet");
  results[1] = perfect(segments[1], 1600, 0);
  joined = join_segments(segments, results).joined;
  CHECK(joined.drilling_found);
  CHECK(joined.clicks.P.size() > 80);
  CHECK(joined.clicks.P.front() >= segments[1].begin);
  CHECK(joined.clicks.P.back() < segments[1].end);
}

TEST_CASE("every index is worked once, and the first failure is the one reported") {
  std::atomic<int> calls[50] = {};
  for_each_index(50, 4, [&](int i) { ++calls[i]; });
  CHECK(std::all_of(std::begin(calls), std::end(calls), [](const auto& n) { return n == 1; }));
  try {
    for_each_index(9, 3, [](int i) {
      if (i >= 4) throw i;
    });
    CHECK(false);
  } catch (int i) {
    CHECK(i == 4);
  }
}
