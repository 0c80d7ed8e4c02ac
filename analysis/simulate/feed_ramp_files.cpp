#include "simulate/feed_ramp_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "rigsound/analysis/rate.hpp"
#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/file/atomic_file.hpp"
#include "rigsound/machine/situation.hpp"
#include "simulate/drill_bus_log.hpp"
#include "simulate/drilling_recording.hpp"
#include "simulate/truth_files.hpp"

namespace rigsound::analysis {
namespace fs = std::filesystem;

namespace {

constexpr double kFrom_bar = 35, kTo_bar = 165, kSnrDb = 6;
constexpr double kLabelled_bar = 10;  // of feed in one label
// The thresholds of the demonstration rig.
constexpr double kUnderfeed_bar = 60, kOverfeed_bar = 120;
constexpr std::uint64_t kTake = 7;  // the situations have 0 to 4
constexpr int kRods = 1;

DrillingCourse course_of(double seconds) {
  DrillingCourse course;
  course.seconds = seconds, course.snr_db = kSnrDb, course.rods = kRods;
  course.start_feed_bar = kFrom_bar, course.end_feed_bar = kTo_bar;
  return course;
}

Situation situation_at(double feed_bar) {
  return feed_bar < kUnderfeed_bar  ? Situation::kUnderfeed
         : feed_bar > kOverfeed_bar ? Situation::kOverfeed
                                    : Situation::kNormal;
}

/// Labels of equal stretches; the situation is that in the middle of each.
std::string labels_of(const DrillingCourse& course, const DrillingLaws& laws) {
  const int count = static_cast<int>(std::lround((kTo_bar - kFrom_bar) / kLabelled_bar));
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double width = (course.end_s() - course.begin_s()) / count, start = course.begin_s() + i * width;
    const double feed = course.feed_bar(start + width / 2);
    text += fmt::format("{:.6f}\t{:.6f}\t{} rods={} rpm={:.0f} feed={:.1f} percussion={:.0f}\n", start,
                        start + width, name(situation_at(feed)), kRods, laws.at(feed, kRods).diesel_rpm, feed,
                        DrillingLaws::kPercussion_bar);
  }
  return text;
}

std::string bus_of(const DrillingCourse& course, const DrillingLaws& laws) {
  return drill_bus_log(course.seconds, [&](double time_s) {
    const double feed = course.feed_bar(time_s);
    DrillMoment moment;
    moment.hammering = time_s >= course.begin_s() && time_s < course.end_s();
    moment.feed_bar = moment.hammering ? feed : 0;
    moment.diesel_rpm = laws.at(feed, kRods).diesel_rpm;
    moment.rods = kRods;
    return moment;
  });
}

std::vector<double> feed_track(const DrillingCourse& course) {
  std::vector<double> feed(static_cast<std::size_t>(course.seconds * kAnalysisRate));
  for (std::size_t n = 0; n < feed.size(); ++n) {
    const double t = static_cast<double>(n) / kAnalysisRate;
    feed[n] = t >= course.begin_s() && t < course.end_s() ? course.feed_bar(t) : 0;
  }
  return feed;
}

}  // namespace

std::vector<std::string> write_ramp(const fs::path& folder, std::uint64_t seed, double seconds) {
  const DrillingLaws laws(seed);
  const DrillingCourse course = course_of(seconds);
  const DrillingRecording r = simulate_drilling(course, laws, {seed, kTake});
  const int rate = static_cast<int>(kAnalysisRate);
  const fs::path truth = folder / "truth", feed = folder / "feed";
  std::vector<double> mixed(r.clean.size());
  std::transform(r.clean.begin(), r.clean.end(), r.background.begin(), mixed.begin(), std::plus<>());
  write_wave(truth / "feed_ramp_clean.wav", r.clean, rate);
  write_wave(truth / "feed_ramp_background.wav", r.background, rate);
  write_clicks_csv(truth / "feed_ramp_truth.csv", r.clicks);
  write_track_csv(truth / "feed_ramp_feed.csv", "feed_bar", feed_track(course));
  write_laws_csv(truth / "feed_ramp_laws.csv", laws, kRods);
  write_slopes_csv(truth / "feed_ramp_slopes.csv", DrillingLaws::slopes());
  write_file(feed / "ramp.txt", labels_of(course, laws));
  write_file(feed / "ramp.log", bus_of(course, laws));
  write_wave(feed / "ramp.wav", mixed, rate);
  return {fmt::format("feed/ramp.wav feed_bar={:.0f}..{:.0f} clicks={} rate_hz={:.2f}..{:.2f}", kFrom_bar,
                      kTo_bar, r.clicks.size(), laws.at(kFrom_bar, kRods).rate_hz,
                      laws.at(kTo_bar, kRods).rate_hz)};
}

}  // namespace rigsound::analysis
