#include "simulate/situation_recording.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/drilling_click.hpp"
#include "simulate/drilling_recording.hpp"
#include "simulate/rattling_recipe.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kBackgroundRms = 0.016;  // 8 dB under normal drilling, as in DrillingCourse

/// One long stretch with the engine alone before and after; open rattling comes in bursts.
std::vector<SimulatedPart> draw_parts(Situation situation, double seconds, SplitMix& r) {
  if (situation != Situation::kOpenRattling) return {{1.0, seconds - 1.0}};
  std::vector<SimulatedPart> bursts;
  for (double t = 1.0; t < seconds - 2.0;) {
    const double length = std::min(r.uniform(0.5, 1.5), seconds - 0.5 - t);
    bursts.push_back({t, t + length});
    t += length + r.uniform(1.2, 2.0);
  }
  return bursts;
}

double rms_within(const std::vector<double>& x, const std::vector<SimulatedPart>& parts) {
  double energy = 0, count = 0;
  for (const SimulatedPart& p : parts) {
    const auto end = std::min(x.size(), static_cast<std::size_t>(p.end * kAnalysisRate));
    for (auto n = static_cast<std::size_t>(p.start * kAnalysisRate); n < end; ++n, ++count)
      energy += x[n] * x[n];
  }
  return std::sqrt(energy / count);
}

void add_part_clicks(SituationRecording& recording, const SimulatedPart& part, SplitMix& r) {
  const auto offset = static_cast<int>(std::nearbyint(part.start * kAnalysisRate));
  for (SimulatedClick c : draw_clicks(recording.process, part.end - part.start, r)) {
    c.P += offset;
    recording.clicks.push_back(c);
  }
}

void render(SituationRecording& recording, const RattlingRecipe& how, const Take& take, int frames) {
  SplitMix machine(kMachine);
  ClickVoice voice;
  voice.envelope = recording.envelope;
  voice.colour = how.colour;
  voice.modes = draw_modes(machine);
  voice.noise_seed = take.stream(2).bits();
  voice.variation_seed = take.stream(3).bits();
  std::vector<int> onsets;
  for (const SimulatedClick& c : recording.clicks) onsets.push_back(c.P);
  recording.clean = render_clicks(voice, recording.clicks, onsets, frames);
  const double gain = DrillingLaws::kNormalRms * std::pow(10, how.level_db / 20) /
                      rms_within(recording.clean, recording.parts);
  for (double& v : recording.clean) v *= gain;
}

SituationRecording simulate_rattling(Situation situation, const Take& take, double seconds) {
  const RattlingRecipe how = rattling_recipe(situation);
  SplitMix structure = take.stream(0);
  SituationRecording recording;
  recording.situation = situation;
  recording.rpm = how.rpm;
  recording.process = how.process;
  recording.process.F0 = recording.rate_hz = structure.uniform(how.rate_low_hz, how.rate_high_hz);
  recording.envelope.attack_samples = how.attack_samples;
  recording.envelope.attack_bend = how.bend / how.attack_samples;
  recording.envelope.decay = std::log(10.0) * how.decay_db / 20 / recording.process.T0();
  recording.parts = draw_parts(situation, seconds, structure);
  for (const SimulatedPart& part : recording.parts) add_part_clicks(recording, part, structure);
  render(recording, how, take, static_cast<int>(std::nearbyint(seconds * kAnalysisRate)));
  recording.background = recorded_background(seconds, how.rpm, how.rpm, kBackgroundRms, take);
  return recording;
}

double feed_of(Situation situation) {
  return situation == Situation::kUnderfeed  ? DrillingLaws::kUnderfeed_bar
         : situation == Situation::kOverfeed ? DrillingLaws::kOverfeed_bar
                                             : DrillingLaws::kNormal_bar;
}

SituationRecording simulate_fed(Situation situation, const Take& take, double seconds, int rods) {
  const DrillingLaws laws(take.seed);
  DrillingCourse course;
  course.seconds = seconds;
  course.start_feed_bar = course.end_feed_bar = feed_of(situation);
  course.rods = rods;
  const DrillingPoint p = laws.at(course.start_feed_bar, rods);
  DrillingRecording drilling = simulate_drilling(course, laws, take);
  SituationRecording recording;
  recording.situation = situation, recording.rods = rods, recording.feed_bar = course.start_feed_bar;
  recording.rpm = p.diesel_rpm;
  recording.process.F0 = recording.rate_hz = p.rate_hz;
  recording.process.jitter = p.gap_variation, recording.process.miss = p.miss_share;
  recording.process.amplitude_cv = p.norm_variation, recording.process.amplitude_rho = kNormCorrelation;
  recording.envelope = drilling_envelope(p);
  recording.parts = {{course.begin_s(), course.end_s()}};
  recording.clicks = std::move(drilling.clicks);
  recording.clean = std::move(drilling.clean);
  recording.background = std::move(drilling.background);
  return recording;
}

}  // namespace

SituationRecording simulate_situation(Situation situation, std::uint64_t seed, double seconds, int rods) {
  const Take take{seed, static_cast<std::uint64_t>(situation) + 8 * static_cast<std::uint64_t>(rods - 1)};
  const bool rattles = situation == Situation::kClosedRattling || situation == Situation::kOpenRattling;
  return rattles ? simulate_rattling(situation, take, seconds) : simulate_fed(situation, take, seconds, rods);
}

}  // namespace rigsound::analysis
