#include "rigsound/analysis/contrast.hpp"

#include <algorithm>
#include <cmath>

#include "contrast/discriminant.hpp"
#include "contrast/loudness.hpp"
#include "contrast/psychometric.hpp"
#include "contrast/runs.hpp"
#include "numeric/quantile.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kStep_bar = 5, kFarStep_bar = 10;  // up to the place of overfeed, and beyond
constexpr int kBetween = 3;  // feeds more between the last that is not heard and the first that is

std::vector<Eigen::MatrixXd> excerpts_of(const Runs& runs) {
  std::vector<Eigen::MatrixXd> excerpts;
  for (const Run& run : runs) excerpts.push_back(run.excerpts);
  return excerpts;
}

double median_rate(const Runs& runs) {
  std::vector<double> rates;
  for (const Run& run : runs) rates.push_back(run.heard.rate_hz);
  return median(std::move(rates));
}

double mean_sone(const Runs& runs) {
  double sum = 0;
  for (const Run& run : runs) sum += run.loudness_sone / static_cast<double>(runs.size());
  return sum;
}

/// Adds up distances and gives their mean.
class MeanDistance {
 public:
  void add(const Run& a, const Run& b) {
    const Distance d = distance(a.heard, b.heard);
    sum_.third_octave_db += d.third_octave_db, sum_.modulation_db += d.modulation_db, sum_.rate += d.rate;
    ++count_;
  }
  Distance mean() const {
    return {sum_.third_octave_db / count_, sum_.modulation_db / count_, sum_.rate / count_};
  }

 private:
  Distance sum_;
  double count_ = 0;
};

/// Between any two runs of each.
Distance floor_of(std::initializer_list<const Runs*> several) {
  MeanDistance within;
  for (const Runs* runs : several)
    for (std::size_t i = 0; i < runs->size(); ++i)
      for (std::size_t j = 0; j < i; ++j) within.add((*runs)[i], (*runs)[j]);
  return within.mean();
}

Distance distance_of(const Runs& a, const Runs& b) {
  MeanDistance between;
  for (const Run& one : a)
    for (const Run& other : b) between.add(one, other);
  return between.mean();
}

PairFigures pair_of(std::size_t first, std::size_t second, const std::vector<Runs>& all) {
  const Runs &a = all[first], &b = all[second];
  const Distance apart = distance_of(a, b), floor = floor_of({&a, &b});
  const Judged judged = cross_validated(excerpts_of(a), excerpts_of(b));
  PairFigures pair;
  pair.first = first, pair.second = second;
  pair.third_octave_db = apart.third_octave_db, pair.third_octave_floor_db = floor.third_octave_db;
  pair.modulation_db = apart.modulation_db, pair.modulation_floor_db = floor.modulation_db;
  pair.rate = apart.rate, pair.rate_floor = floor.rate;
  pair.phon = loudness_level_phon(mean_sone(b)) - loudness_level_phon(mean_sone(a));
  pair.right = static_cast<double>(judged.right) / judged.of;
  return pair;
}

SubjectGroup compare(const std::vector<ContrastSubject>& subjects, const std::vector<Runs>& runs) {
  SubjectGroup group;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const double sone = mean_sone(runs[i]);
    group.subjects.push_back({subjects[i], median_rate(runs[i]), sone, loudness_level_phon(sone)});
    for (std::size_t j = i + 1; j < subjects.size(); ++j) group.pairs.push_back(pair_of(i, j, runs));
  }
  return group;
}

std::vector<DrillSetting> settings_of(const std::vector<ContrastSubject>& subjects) {
  std::vector<DrillSetting> settings;
  for (const ContrastSubject& subject : subjects) settings.push_back(subject.setting);
  return settings;
}

std::vector<double> feed_grid(const ContrastPlan& plan) {
  std::vector<double> feeds;
  double feed = kStep_bar * std::ceil(plan.lowest_bar / kStep_bar);
  while (feed <= plan.highest_bar) {
    if (std::fabs(feed - plan.points.normal) > 1e-6) feeds.push_back(feed);
    const bool far = feed >= plan.points.overfeed && std::fmod(feed, kFarStep_bar) < 1e-6;
    feed += far ? kFarStep_bar : kStep_bar;
  }
  return feeds;
}

/// The feed against normal, whose runs are `normal`.
FeedFigures feed_figures(double feed_bar, const Runs& runs, const Runs& normal) {
  const Distance apart = distance_of(normal, runs);
  const Judged judged = cross_validated(excerpts_of(normal), excerpts_of(runs));
  const double sone = mean_sone(runs);
  return {feed_bar, apart.third_octave_db,     apart.modulation_db, median_rate(runs),
          sone,     loudness_level_phon(sone), judged.right,        judged.of};
}

enum class Side { kUnder = -1, kOver = 1 };

/// How far from normal towards `side`; negative on the other.
double away(const FeedFigures& figures, double normal_bar, Side side) {
  return (figures.feed_bar - normal_bar) * static_cast<int>(side);
}

bool is_heard(const FeedFigures& figures) { return figures.right >= kToldRight * figures.of; }

/// Feeds between the farthest one not heard before, and the nearest heard: none if none is.
std::vector<double> between(const std::vector<FeedFigures>& feed, double normal_bar, Side side) {
  double first = 1e9, last = 0;
  for (const FeedFigures& f : feed)
    if (const double bar = away(f, normal_bar, side); bar > 0 && is_heard(f)) first = std::min(first, bar);
  if (first > 1e8) return {};
  for (const FeedFigures& f : feed)
    if (const double bar = away(f, normal_bar, side); bar > 0 && bar < first) last = std::max(last, bar);
  std::vector<double> more;
  for (int i = 1; i <= kBetween; ++i)
    more.push_back(normal_bar + static_cast<int>(side) * (last + (first - last) * i / (kBetween + 1)));
  return more;
}

Reach reach(const Contrast& contrast, Side side) {
  std::vector<Trial> trials;
  for (const FeedFigures& f : contrast.feed)
    if (const double bar = away(f, contrast.plan.points.normal, side); bar > 0 && f.of > 0)
      trials.push_back({bar, f.right, f.of});
  return reach_of(trials, contrast.options.seed);
}

void add_feeds(const std::vector<double>& feeds, const Runs& normal, Listener& listener, Contrast& contrast) {
  std::vector<DrillSetting> settings;
  for (const double feed : feeds) {
    settings.push_back(contrast.plan.situations.front().setting);
    settings.back().feed_bar = feed;
  }
  const std::vector<Runs> runs = listener.listen_to(settings);
  for (std::size_t i = 0; i < feeds.size(); ++i)
    contrast.feed.push_back(feed_figures(feeds[i], runs[i], normal));
}

void measure_feed(const Runs& normal, Listener& listener, Contrast& contrast) {
  const double normal_bar = contrast.plan.points.normal, sone = mean_sone(normal);
  add_feeds(feed_grid(contrast.plan), normal, listener, contrast);
  std::vector<double> more = between(contrast.feed, normal_bar, Side::kUnder);
  for (const double feed : between(contrast.feed, normal_bar, Side::kOver)) more.push_back(feed);
  add_feeds(more, normal, listener, contrast);
  contrast.floor_db = floor_of({&normal}).third_octave_db;
  contrast.feed.push_back({normal_bar, contrast.floor_db, floor_of({&normal}).modulation_db,
                           median_rate(normal), sone, loudness_level_phon(sone), 0, 0});
  std::sort(contrast.feed.begin(), contrast.feed.end(),
            [](const FeedFigures& a, const FeedFigures& b) { return a.feed_bar < b.feed_bar; });
  contrast.under = reach(contrast, Side::kUnder);
  contrast.over = reach(contrast, Side::kOver);
}

}  // namespace

bool PairFigures::above_floor() const {
  return third_octave_db >= kFloors * third_octave_floor_db ||
         modulation_db >= kFloors * modulation_floor_db || (rate > 0 && rate >= kFloors * rate_floor);
}

Contrast measure_contrast(const ContrastPlan& plan, const ContrastOptions& options, const RenderSound& render,
                          const std::function<void(int, int)>& progress) {
  Contrast contrast;
  contrast.plan = plan, contrast.options = options;
  const std::size_t expected = plan.situations.size() + plan.rods.size() + plan.rocks.size() +
                               feed_grid(plan).size() + 2 * static_cast<std::size_t>(kBetween);
  Listener listener(options, render, progress, static_cast<int>(expected));
  const std::vector<Runs> situations = listener.listen_to(settings_of(plan.situations));
  contrast.situations = compare(plan.situations, situations);
  contrast.rods = compare(plan.rods, listener.listen_to(settings_of(plan.rods)));
  contrast.rocks = compare(plan.rocks, listener.listen_to(settings_of(plan.rocks)));
  measure_feed(situations.front(), listener, contrast);
  return contrast;
}

}  // namespace rigsound::analysis
