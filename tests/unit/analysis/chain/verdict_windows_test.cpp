// Windows of the verdict, and what recordings of several things are told to hold.
#include "chain/verdict_windows.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "analysis/noise.hpp"
#include "chain/clip_neighbours.hpp"
#include "rigsound/analysis/chain.hpp"
#include "simulate/drillbench_clip.hpp"

using namespace rigsound::analysis;

namespace {

constexpr long kSecond = 48000;

std::vector<VerdictWindow> windows(const std::vector<double>& probability) {
  std::vector<VerdictWindow> verdict;
  for (std::size_t k = 0; k < probability.size(); ++k)
    verdict.push_back({static_cast<double>(k), static_cast<double>(k) + 2, probability[k]});
  return verdict;
}

}  // namespace

TEST_CASE("a window of two seconds begins every second, and the last one reaches the end") {
  CHECK(plan_windows(kSecond).size() == 1);
  CHECK(plan_windows(2 * kSecond).size() == 1);
  const std::vector<Segment> planned = plan_windows(5 * kSecond + 1000);
  REQUIRE(planned.size() == 5);
  for (std::size_t k = 0; k < planned.size(); ++k) {
    CHECK(planned[k].begin == (k < 4 ? static_cast<long>(k) * kSecond : 3 * kSecond + 1000));
    CHECK(planned[k].end - planned[k].begin == 2 * kSecond);
  }
}

TEST_CASE(
    "every window is judged once, in the segment that holds most of it, and every segment to its seams") {
  for (long length = kSecond; length < 40 * kSecond; length += 31337) {
    const std::vector<Segment> segments = plan_segments(length), planned = plan_windows(length);
    const auto held = windows_by_segment(planned, segments);
    std::size_t count = 0;
    for (std::size_t k = 0; k < segments.size(); ++k) {
      count += held[k].size();
      REQUIRE(!held[k].empty());
      long from = k == 0 ? 0 : (segments[k - 1].end - segments[k].begin) / 2;  // own sound, up to the seams
      const long to = k + 1 == segments.size()
                          ? segments[k].end - segments[k].begin
                          : (segments[k + 1].begin + segments[k].end) / 2 - segments[k].begin;
      for (const Segment& window : held[k]) {
        const long inside =
            std::min(window.end, segments[k].end - segments[k].begin) - std::max(0L, window.begin);
        CHECK(inside >= std::min(length, 5 * kSecond / 4));
        CHECK(window.begin <= from);
        from = std::max(from, window.end);
      }
      CHECK(from >= to - 1);
    }
    CHECK(count == planned.size());
  }
}

TEST_CASE("neighbouring windows that drill are one stretch, and text tells those that are not all") {
  const auto verdict = windows({0.9, 0.8, 0.1, 0.1, 0.1, 0.7});
  const std::vector<Stretch> stretches = drilling_stretches(verdict);
  REQUIRE(stretches.size() == 2);
  CHECK(stretches[0].start_s == 0);
  CHECK(stretches[0].end_s == 3);
  CHECK(stretches[1].start_s == 5);
  CHECK(stretches_text(verdict) == "drilling in 0.0-3.0, 5.0-7.0 of 7.0 s");
  CHECK(stretches_text(windows({0.9, 0.9})).empty());
  CHECK(stretches_text(windows({0.1, 0.1})).empty());
}

TEST_CASE("drilling goes on through windows that hardly tell it, both ways, and does not begin in one") {
  CHECK(drilling_windows(windows({0.3, 0.1, 0.3, 0.3, 0.6, 0.25, 0.2, 0.19, 0.4})) ==
        std::vector<bool>{false, false, true, true, true, true, true, false, false});
  CHECK(drilling_windows(windows({0.49, 0.49})) == std::vector<bool>{false, false});
  CHECK(drilling_windows({}).empty());
}

TEST_CASE("a clip that may drill does beside one that does, and keeps the clicks of its windows that do") {
  const auto clip = [](const std::vector<double>& probability) {
    ChainResult r;
    r.verdict = windows(probability);
    for (int P = 0; P < 4 * kSecond; P += kSecond / 20) r.clicks.P.push_back(P), r.clicks.beta.push_back(P);
    r.reason = "a doubt";
    return std::vector<ChainResult>{r};
  };
  std::vector<std::vector<ChainResult>> clips{clip({0.3, 0.1}), clip({0.1, 0.9, 0.8}), clip({0.3, 0.3, 0.1}),
                                              clip({0.3, 0.4})};
  clips[3][0].clicks = {};  // too few to keep any
  decide_beside_neighbours(clips);
  for (const std::size_t refused : {0U, 3U}) {
    CHECK(!clips[refused][0].drilling_found);
    CHECK(clips[refused][0].reason == "a doubt");
    CHECK(clips[refused][0].clicks.P.empty());
  }
  for (const std::size_t found : {1U, 2U}) {
    CHECK(clips[found][0].drilling_found);
    CHECK(clips[found][0].reason.empty());
  }
  CHECK(clips[1][0].clicks.P.front() == kSecond);
  CHECK(clips[2][0].clicks.P.back() == 3 * kSecond - kSecond / 20);
  CHECK(clips[2][0].clicks.beta.back() == clips[2][0].clicks.P.back());
}

TEST_CASE("a burst in a long recording is found where it is, however much is around it") {
  TestNoise noise(5);
  const DrillBenchClip clip = drillbench_clip(103, 1.8);
  std::vector<float> x;
  for (long n = 0; n < 9 * kSecond; ++n) x.push_back(static_cast<float>(0.004 * noise.normal()));
  const long begin = 4 * kSecond + 12345;
  for (std::size_t n = 0; n < clip.clean.size(); ++n)
    x[static_cast<std::size_t>(begin) + n] += static_cast<float>(0.05 * clip.clean[n]);
  const ChainResult result = run_chain(x, {});
  CHECK(result.drilling_found);
  for (const VerdictWindow& w : result.verdict) {
    const double start_s = static_cast<double>(begin) / kSecond;
    if (w.end_s < start_s || w.start_s > start_s + 1.8) CHECK(w.probability < kDrillingProbability);
  }
  const auto inside = [&](long P) { return P >= begin - 480 && P < begin + 19 * kSecond / 10; };
  CHECK(std::all_of(result.clicks.P.begin(), result.clicks.P.end(), inside));
  const auto impacts = static_cast<double>(std::count_if(
      clip.clicks.begin(), clip.clicks.end(), [](const auto& c) { return c.kind != ClickKind::kBounce; }));
  CHECK(static_cast<double>(result.clicks.P.size()) == doctest::Approx(impacts).epsilon(0.06));
}
