#include "analyzer/bus_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rigsound/config/sound_set_index.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kSmoothing_s = 0.5;  // the pump's ripple is no movement of the feed

using Moments = std::vector<BusMoment>;

/// Moments [first, last).
struct Span {
  std::size_t first, last;
  double seconds() const { return static_cast<double>(last - first) * kBusStep_s; }
};

bool alike(const BusMoment& a, const BusMoment& b) {
  return a.situation == b.situation && a.rods == b.rods && a.rock == b.rock;
}

bool rattles(const BusMoment& m) {
  return m.situation == Situation::kClosedRattling || m.situation == Situation::kOpenRattling;
}

double shortest_s(const BusMoment& m) { return rattles(m) ? kShortestBurst_s : kShortestDrilling_s; }

/// Stretches of hammering in which nothing but the feed changes.
std::vector<Span> stretches(const Moments& moments, Span within) {
  std::vector<Span> found;
  for (std::size_t i = within.first; i < within.last;) {
    std::size_t end = i + 1;
    while (end < within.last && alike(moments[i], moments[end])) ++end;
    if (moments[i].situation) found.push_back({i, end});
    i = end;
  }
  return found;
}

Span settled(Span span) {
  const auto cut = std::min(static_cast<std::size_t>(kSettle_s / kBusStep_s), (span.last - span.first) / 2);
  return {span.first + cut, span.last - cut};
}

std::vector<double> smoothed_feed(const Moments& moments, Span span) {
  const auto half = static_cast<std::size_t>(kSmoothing_s / 2 / kBusStep_s);
  std::vector<double> feed;
  for (std::size_t i = span.first; i < span.last; ++i) {
    const std::size_t reach = std::min({half, i - span.first, span.last - 1 - i});
    double sum = 0;
    for (std::size_t k = i - reach; k <= i + reach; ++k) sum += moments[k].feed_bar;
    feed.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  return feed;
}

/// Cuts where the feed has moved on by kPartFeed_bar, or by an even share of all its movement when that is
/// less.
std::vector<Span> cut_by_feed(const Moments& moments, Span span) {
  const std::vector<double> feed = smoothed_feed(moments, span);
  const auto [least, most] = std::minmax_element(feed.begin(), feed.end());
  const double range = *most - *least, parts = std::max(1.0, std::ceil(range / kPartFeed_bar));
  const double allowed = range / parts + 1e-9;
  std::vector<Span> cut;
  std::size_t first = 0;
  double low = feed[0], high = feed[0];
  for (std::size_t i = 1; i < feed.size(); ++i) {
    low = std::min(low, feed[i]), high = std::max(high, feed[i]);
    if (high - low <= allowed) continue;
    cut.push_back({span.first + first, span.first + i});
    first = i, low = high = feed[i];
  }
  cut.push_back({span.first + first, span.last});
  return cut;
}

double mean(const Moments& moments, Span span, double BusMoment::*value) {
  double sum = 0;
  for (std::size_t i = span.first; i < span.last; ++i) sum += moments[i].*value;
  return sum / static_cast<double>(span.last - span.first);
}

Label label_of(const Moments& moments, Span span, double offset_s, const std::vector<std::string>& rocks) {
  const BusMoment& first = moments[span.first];
  const auto tenths = [&](double BusMoment::*value) {
    return std::round(mean(moments, span, value) * 10) / 10;
  };
  Label label;
  label.start_s = offset_s + static_cast<double>(span.first) * kBusStep_s;
  label.end_s = offset_s + static_cast<double>(span.last) * kBusStep_s;
  label.situation = *first.situation;
  label.rods = first.rods;
  if (first.rock >= 0 && first.rock < static_cast<int>(rocks.size())) label.rock = rocks[first.rock];
  label.rpm = std::round(mean(moments, span, &BusMoment::rpm));
  const double percussion_bar = tenths(&BusMoment::percussion_bar);
  if (percussion_bar >= config::kRecordedPressures.min) label.percussion_bar = percussion_bar;
  if (!rattles(first))
    label.feed_bar = std::max(tenths(&BusMoment::feed_bar), config::kRecordedPressures.min);
  return label;
}

/// Those moments that lie in the recording.
Span recorded(const Moments& moments, double offset_s, double recording_s) {
  const auto count = static_cast<double>(moments.size());
  const auto at = [&](double s) {
    return static_cast<std::size_t>(std::clamp(std::ceil(s / kBusStep_s - 1e-6), 0.0, count));
  };
  return {at(-offset_s), at(recording_s - offset_s)};
}

}  // namespace

BusParts bus_parts(const BusCourse& course, double offset_s, double recording_s,
                   const std::vector<std::string>& rocks) {
  const Moments& moments = course.moments;
  BusParts parts;
  double left_out_s = 0;
  for (const Span& stretch : stretches(moments, recorded(moments, offset_s, recording_s))) {
    const Span span = settled(stretch);
    const bool drills = !rattles(moments[span.first]);
    for (const Span& part : drills ? cut_by_feed(moments, span) : std::vector<Span>{span}) {
      if (part.seconds() < shortest_s(moments[part.first]))
        left_out_s += part.seconds();
      else
        parts.labels.push_back(label_of(moments, part, offset_s, rocks));
    }
  }
  if (left_out_s >= 0.1)
    parts.notes.push_back(fmt::format(
        "{:.1f} s of hammering left out: shorter than {} s, or the feed moves by {} bar in less than that",
        left_out_s, kShortestDrilling_s, kPartFeed_bar));
  return parts;
}

}  // namespace rigsound::analysis
