#include "scene/feed_axis.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "scene/bank_choice.hpp"

namespace rigsound::scene {
namespace {

// Where a trend saturates: how far beyond the outermost bank each parameter can go.
constexpr double kMostLevel = 1.4;  // 12 dB
constexpr double kMostDecay = 1.4;  // a factor of 4
constexpr double kMostVariation = 0.3;
constexpr double kMostGap = 0.7;  // a factor of 2
constexpr double kMostTilt = kLargestTilt;

/// Straight at first, then smoothly towards +-limit.
double saturated(double x, double limit) noexcept { return x / std::sqrt(1 + x * x / (limit * limit)); }

/// The two items that `x` lies between, and how far it has gone from the one to the other; beyond an end both
/// are that end.
template <class Item>
struct Neighbours {
  const Item &low, &high;
  double share;  ///< 0...1 of `high`
};

/// `items` rise in `key`; there is at least one. Thread: RT.
template <class Item, class Number>
Neighbours<Item> neighbours(const std::vector<Item>& items, Number Item::*key, double x) noexcept {
  std::size_t above = 0;
  while (above < items.size() && items[above].*key <= x) ++above;
  const Item& low = items[above == 0 ? 0 : above - 1];
  const Item& high = items[std::min(above, items.size() - 1)];
  const double apart = high.*key - low.*key;
  return {low, high, apart > 0 ? (x - low.*key) / apart : 0.0};
}

bool drills(Situation s) noexcept {
  return s == Situation::kUnderfeed || s == Situation::kNormal || s == Situation::kOverfeed;
}

double slope(double from, double to, double bar) noexcept { return bar > 0 ? (to - from) / bar : 0.0; }

/// Slopes from one bank to another that was recorded `bar` higher, all but the brightness.
FeedLaws laws_between(const ClickBank& a, const ClickBank& b, double bar) noexcept {
  FeedLaws laws;
  laws.ln_gap = slope(dsp::log(a.mean_gap_samples), dsp::log(b.mean_gap_samples), bar);
  laws.ln_level = slope(dsp::log(a.mean_amplitude) + a.gain_db * (dsp::kLn10 / 20),
                        dsp::log(b.mean_amplitude) + b.gain_db * (dsp::kLn10 / 20), bar);
  laws.ln_decay = a.decay > 0 && b.decay > 0 ? slope(dsp::log(a.decay), dsp::log(b.decay), bar) : 0.0;
  laws.gap_variation =
      slope(a.gap_deviation_samples / a.mean_gap_samples, b.gap_deviation_samples / b.mean_gap_samples, bar);
  laws.amplitude_variation =
      slope(a.amplitude_deviation / a.mean_amplitude, b.amplitude_deviation / b.mean_amplitude, bar);
  return laws;
}

}  // namespace

FeedPoints feed_points(const SceneOptions& o) noexcept {
  const auto point = [](double given, double otherwise) { return given > 0 ? given : otherwise; };
  FeedPoints points{};
  points.underfeed = point(o.feed_points.underfeed, 0.5 * (o.contact_bar + o.underfeed_bar));
  points.normal = point(o.feed_points.normal, 0.5 * (o.underfeed_bar + o.overfeed_bar));
  points.overfeed = point(o.feed_points.overfeed, 2 * o.overfeed_bar - points.normal);
  return points;
}

double FeedPoints::deviation(double feed_bar) const noexcept {
  const double side = feed_bar < normal ? normal - underfeed : overfeed - normal;
  return side > 0 ? (feed_bar - normal) / side : 0.0;
}

FeedAxis::FeedAxis(const ClickSpectra& spectra, const SceneOptions& options, int string)
    : sounds_(&spectra.sounds()),
      options_(options),
      points_(feed_points(options)),
      level_(spectra.sounds(), string) {
  const SoundSet& sounds = *sounds_;
  for (int rock = -1; rock < static_cast<int>(sounds.rocks.size()); ++rock) {
    std::vector<int> counts;
    for (const BankUse& use : sounds.uses)
      if (drills(use.situation) && use.rods > 0 && (use.rock == rock || use.rock < 0))
        counts.push_back(use.rods);
    if (counts.empty()) counts.push_back(1);
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    std::vector<Series>& series = rocks_.emplace_back();
    for (const int rods : counts) series.push_back(series_of(rods, rock, spectra));
  }
}

/// Of each situation the banks nearest in rods and rock, so that a rod count recorded in one situation only
/// is whole.
FeedAxis::Series FeedAxis::series_of(int rods, int rock, const ClickSpectra& spectra) const {
  Series series{rods, {}, {}, {}};
  const auto place_of = [&](const BankUse& use) {
    if (use.feed_bar > 0) return use.feed_bar;
    return use.situation == Situation::kUnderfeed  ? points_.underfeed
           : use.situation == Situation::kOverfeed ? points_.overfeed
                                                   : points_.normal;
  };
  for (const Situation s : {Situation::kUnderfeed, Situation::kNormal, Situation::kOverfeed}) {
    int nearest = -1;
    for (const BankUse& use : sounds_->uses)
      if (use.situation == s && (nearest < 0 || distance(use, rods, rock) < nearest))
        nearest = distance(use, rods, rock);
    for (const BankUse& use : sounds_->uses)
      if (use.situation == s && distance(use, rods, rock) == nearest)
        series.points.push_back(
            {place_of(use), use.percussion_bar > 0 ? use.percussion_bar : options_.percussion_nominal_bar,
             &use});
  }
  std::stable_sort(series.points.begin(), series.points.end(),
                   [](const Point& a, const Point& b) { return a.feed_bar < b.feed_bar; });
  if (series.points.size() > 1) find_ends(rock, series, spectra);
  return series;
}

/// Beyond its ends a series goes on by the last laws of the set that hold for it, else by those of the two
/// banks nearest to the end.
void FeedAxis::find_ends(int rock, Series& series, const ClickSpectra& spectra) const {
  const std::vector<Point>& points = series.points;
  const auto spectrum = [&](const Point& point) -> const drill::ClickSpectrum& {
    return spectra.of(*point.use);
  };
  const auto between = [&](const Point& a, const Point& b) {
    const double bar = b.feed_bar - a.feed_bar;
    FeedLaws laws = laws_between(bank_of(a), bank_of(b), bar);
    laws.tilt_db_per_octave = slope(spectrum(a).tilt_db_per_octave(), spectrum(b).tilt_db_per_octave(), bar);
    return laws;
  };
  const auto given = std::find_if(sounds_->laws.rbegin(), sounds_->laws.rend(), [&](const FeedLaws& laws) {
    return (laws.rods == 0 || laws.rods == series.rods) && (laws.rock < 0 || laws.rock == rock);
  });
  const bool found = given != sounds_->laws.rend();
  series.below.laws = found ? *given : between(points[0], points[1]);
  series.above.laws = found ? *given : between(points[points.size() - 2], points.back());
  series.below.norm = TiltedNorm(spectrum(points.front()));
  series.above.norm = TiltedNorm(spectrum(points.back()));
}

const std::vector<FeedAxis::Series>& FeedAxis::rock_series(int rock) const noexcept {
  const int last = static_cast<int>(rocks_.size()) - 2;
  return rocks_[rock >= 0 && rock <= last ? rock + 1 : 0];
}

void FeedAxis::draw(const Point& point, double share, int rock, FeedPlace& place) const noexcept {
  const int at = place.banks.add(bank_of(point), share);
  if (at >= 0) place.uses[at] = point.use;
  if (share > 0) place.trend.ln_level += share * level_.of_rock(rock, point.use->rock);
}

void FeedAxis::add(const Series& series, double feed_bar, int rock, double weight,
                   FeedPlace& place) const noexcept {
  const std::vector<Point>& points = series.points;
  if (points.empty() || weight <= 0) return;
  const auto [low, high, w] = neighbours(points, &Point::feed_bar, feed_bar);
  draw(low, weight * (1 - w), rock, place);
  draw(high, weight * w, rock, place);
  place.percussion_bar += weight * (low.percussion_bar + w * (high.percussion_bar - low.percussion_bar));

  const double beyond = feed_bar - std::clamp(feed_bar, points.front().feed_bar,
                                              points.back().feed_bar);  // bar, negative below
  if (beyond == 0) return;
  const auto& [laws, norm] = beyond < 0 ? series.below : series.above;
  const double tilt = saturated(laws.tilt_db_per_octave * beyond, kMostTilt);
  place.trend.ln_gap += weight * saturated(laws.ln_gap * beyond, kMostGap);
  place.trend.ln_level += weight * saturated(laws.ln_level * beyond, kMostLevel);
  place.trend.ln_decay += weight * saturated(laws.ln_decay * beyond, kMostDecay);
  place.trend.gap_variation += weight * saturated(laws.gap_variation * beyond, kMostVariation);
  place.trend.amplitude_variation += weight * saturated(laws.amplitude_variation * beyond, kMostVariation);
  place.trend.tilt_db_per_octave += weight * tilt;
  place.ln_tilted_norm += weight * norm.ln(tilt);
}

FeedPlace FeedAxis::place(double feed_bar, double rods, int rock) const noexcept {
  const std::vector<Series>& series = rock_series(rock);
  const auto [fewer, more, w] = neighbours(series, &Series::rods, rods);
  FeedPlace place;
  add(fewer, feed_bar, rock, 1 - w, place);
  add(more, feed_bar, rock, w, place);
  const double recorded = std::clamp<double>(rods, series.front().rods, series.back().rods);
  place.trend.ln_level += level_.of_joints(rods - recorded);
  return place;
}

/// What `end` and everything beyond it up to `last_bar` cannot follow.
void FeedAxis::add_limits(const Point& end, const FeedLaws& laws, double last_bar, FeedReach& reach) const {
  // The slope of saturated() has fallen to a half where x = limit * sqrt(2^(2/3) - 1).
  constexpr double kHalf = 0.7664;
  const ClickBank& bank = bank_of(end);
  const double direction = last_bar < end.feed_bar ? -1 : 1, room = std::fabs(last_bar - end.feed_bar);
  const auto limit = [&](std::string_view parameter, double slope, double most, double left) {
    const double falling = slope * direction < 0 ? left : most;
    const double bars = slope == 0 ? room : std::min(kHalf * most, falling) / std::fabs(slope);
    if (bars < room) reach.limits.push_back({parameter, end.feed_bar + direction * bars});
  };
  limit("rate", laws.ln_gap, kMostGap, kMostGap);
  limit("level", laws.ln_level, kMostLevel, kMostLevel);
  limit("decay", laws.ln_decay, kMostDecay, kMostDecay);
  limit("gap variation", laws.gap_variation, kMostVariation,
        bank.gap_deviation_samples / bank.mean_gap_samples);
  limit("amplitude variation", laws.amplitude_variation, kMostVariation,
        bank.amplitude_deviation / bank.mean_amplitude);
  limit("brightness", laws.tilt_db_per_octave, kMostTilt, kMostTilt);
}

std::vector<FeedReach> FeedAxis::reach() const {
  std::vector<FeedReach> all;
  for (std::size_t r = 0; r < rocks_.size(); ++r)
    for (const Series& series : rocks_[r]) {
      const std::vector<Point>& points = series.points;
      if (points.empty()) continue;
      FeedReach reach{series.rods,
                      static_cast<int>(r) - 1,
                      static_cast<int>(points.size()),
                      points.front().feed_bar,
                      points.back().feed_bar,
                      {}};
      add_limits(points.front(), series.below.laws, kFeedPressures.min, reach);
      add_limits(points.back(), series.above.laws, kFeedPressures.max, reach);
      all.push_back(std::move(reach));
    }
  return all;
}

std::vector<FeedReach> feed_reach(const SoundSet& sounds, const SceneOptions& options) {
  return FeedAxis(sounds, options).reach();
}

}  // namespace rigsound::scene
