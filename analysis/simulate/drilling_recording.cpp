#include "simulate/drilling_recording.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/background_noise.hpp"
#include "simulate/drilling_click.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kShortestGap = 0.35;  // of the mean gap
constexpr double kLeastBeta = 0.25, kMostDeviations = 2.5;

int samples_of(double seconds) { return static_cast<int>(std::nearbyint(seconds * kAnalysisRate)); }

std::vector<SimulatedClick> draw_impacts(const DrillingCourse& course, const DrillingLaws& laws,
                                         SplitMix& r) {
  const double fresh = std::sqrt(1 - kNormCorrelation * kNormCorrelation);
  std::vector<SimulatedClick> clicks;
  double level = r.normal(),
         t = course.begin_s() + 0.5 * r.uniform() / laws.at(course.feed_bar(0), 1).rate_hz;
  while (t < course.end_s()) {
    const DrillingPoint p = laws.at(course.feed_bar(t), course.rods);
    const double beta = std::max(kLeastBeta, 1 + p.norm_variation * level);
    if (r.uniform() >= p.miss_share) clicks.push_back({samples_of(t), beta, ClickKind::kImpact});
    level = kNormCorrelation * level + fresh * r.normal();
    const double deviation = std::clamp(r.normal(), -kMostDeviations, kMostDeviations);
    t += std::max(kShortestGap, 1 + p.gap_variation * deviation) / p.rate_hz;
  }
  return clicks;
}

std::vector<double> render(const std::vector<SimulatedClick>& clicks, const DrillingCourse& course,
                           const DrillingLaws& laws, const Take& take) {
  DrillingClicks source(course.rods, take.stream(2).bits(), take.stream(3).bits());
  std::vector<double> y(static_cast<std::size_t>(samples_of(course.seconds)), 0.0);
  for (const SimulatedClick& c : clicks) {
    const DrillingPoint p = laws.at(course.feed_bar(c.P / kAnalysisRate), course.rods);
    const std::vector<double> click = source.draw(p);
    const std::size_t count = std::min(click.size(), y.size() - static_cast<std::size_t>(c.P));
    for (std::size_t n = 0; n < count; ++n) y[c.P + n] += c.beta * p.norm * click[n];
  }
  return y;
}

}  // namespace

double DrillingCourse::feed_bar(double time_s) const {
  const double share = std::clamp((time_s - begin_s()) / (end_s() - begin_s()), 0.0, 1.0);
  return start_feed_bar + share * (end_feed_bar - start_feed_bar);
}

DrillingRecording simulate_drilling(const DrillingCourse& course, const DrillingLaws& laws,
                                    const Take& take) {
  SplitMix structure = take.stream(0);
  DrillingRecording recording;
  recording.clicks = draw_impacts(course, laws, structure);
  recording.clean = render(recording.clicks, course, laws, take);
  const double start_rpm = laws.at(course.start_feed_bar, course.rods).diesel_rpm,
               end_rpm = laws.at(course.end_feed_bar, course.rods).diesel_rpm;
  recording.background = recorded_background(
      course.seconds, start_rpm, end_rpm, DrillingLaws::kNormalRms * std::pow(10, -course.snr_db / 20), take);
  return recording;
}

std::vector<double> recorded_background(double seconds, double start_rpm, double end_rpm, double rms,
                                        const Take& take) {
  constexpr double kDrift = 0.03;  // the speed never stands quite still
  SplitMix machine(kMachine + 1), noise = take.stream(4);
  std::vector<double> background = background_noise(
      BackgroundScene::ramp(seconds, start_rpm * (1 - kDrift), end_rpm * (1 + kDrift)), machine, noise);
  for (double& v : background) v *= rms;
  return background;
}

}  // namespace rigsound::analysis
