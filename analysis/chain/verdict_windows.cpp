#include "chain/verdict_windows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

constexpr long kWindow = static_cast<long>(kVerdictWindow_s * kAnalysisRate);
constexpr long kHop = static_cast<long>(kVerdictHop_s * kAnalysisRate);

std::size_t holder(const Segment& window, const std::vector<Segment>& segments) {
  const auto held = [&window](const Segment& segment) {
    return std::min(window.end, segment.end) - std::max(window.begin, segment.begin);
  };
  const auto most = std::max_element(segments.begin(), segments.end(),
                                     [&held](const auto& a, const auto& b) { return held(a) < held(b); });
  return static_cast<std::size_t>(most - segments.begin());
}

}  // namespace

std::vector<Segment> plan_windows(long length) {
  if (length <= kWindow) return {{0, length}};
  std::vector<Segment> windows;
  for (long begin = 0; begin + kWindow <= length; begin += kHop) windows.push_back({begin, begin + kWindow});
  if (windows.back().end < length) windows.push_back({length - kWindow, length});
  return windows;
}

std::vector<std::vector<Segment>> windows_by_segment(const std::vector<Segment>& windows,
                                                     const std::vector<Segment>& segments) {
  std::vector<std::vector<Segment>> held(segments.size());
  for (const Segment& window : windows) {
    const std::size_t k = holder(window, segments);
    held[k].push_back({window.begin - segments[k].begin, window.end - segments[k].begin});
  }
  return held;
}

std::vector<bool> drilling_windows(const std::vector<VerdictWindow>& verdict) {
  std::vector<bool> drills;
  for (const VerdictWindow& window : verdict) drills.push_back(window.probability >= kDrillingProbability);
  const auto goes_on = [&](std::size_t k, std::size_t neighbour) {
    if (drills[neighbour] && verdict[k].probability >= kStillDrilling) drills[k] = true;
  };
  for (std::size_t k = 1; k < verdict.size(); ++k) goes_on(k, k - 1);
  for (std::size_t k = verdict.size(); k-- > 1;) goes_on(k - 1, k);
  return drills;
}

std::vector<Stretch> drilling_stretches(const std::vector<VerdictWindow>& verdict) {
  std::vector<Stretch> stretches;
  const std::vector<bool> drills = drilling_windows(verdict);
  for (std::size_t k = 0; k < verdict.size(); ++k) {
    if (!drills[k]) continue;
    const VerdictWindow& window = verdict[k];
    if (!stretches.empty() && window.start_s <= stretches.back().end_s)
      stretches.back().end_s = window.end_s;
    else
      stretches.push_back({window.start_s, window.end_s});
  }
  return stretches;
}

std::string stretches_text(const std::vector<VerdictWindow>& verdict) {
  const std::vector<Stretch> stretches = drilling_stretches(verdict);
  if (stretches.empty()) return {};
  const double end_s = verdict.back().end_s;
  if (stretches.size() == 1 && stretches[0].start_s <= 0 && stretches[0].end_s >= end_s) return {};
  std::string text;
  for (const Stretch& s : stretches)
    text += fmt::format("{}{:.1f}-{:.1f}", text.empty() ? "" : ", ", s.start_s, s.end_s);
  return fmt::format("drilling in {} of {:.1f} s", text, end_s);
}

}  // namespace rigsound::analysis
