#include "simulate/situation_recording.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/background_noise.hpp"
#include "simulate/situation_recipe.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kNormalRms = 0.04;        // full scale = 1; leaves room for a burst 12 dB louder
constexpr double kBackgroundRms = 0.016;   // 8 dB under normal drilling
constexpr std::uint64_t kMachine = 77001;  // seeds of what belongs to the machine, not to the recording

/// A stream of its own for every purpose of every recording.
SplitMix stream(std::uint64_t seed, Situation situation, std::uint64_t purpose) {
  return SplitMix(dsp::mix64(seed) + dsp::mix64(8 * static_cast<std::uint64_t>(situation) + purpose + 1));
}

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

void scale(std::vector<double>& x, double gain) {
  for (double& v : x) v *= gain;
}

void add_part_clicks(SituationRecording& recording, const SimulatedPart& part, SplitMix& r) {
  const auto offset = static_cast<int>(std::nearbyint(part.start * kAnalysisRate));
  for (SimulatedClick c : draw_clicks(recording.process, part.end - part.start, r)) {
    c.P += offset;
    recording.clicks.push_back(c);
  }
}

void render(SituationRecording& recording, const SituationRecipe& how, std::uint64_t seed, int frames) {
  SplitMix machine(kMachine);
  ClickVoice voice;
  voice.envelope = recording.envelope;
  voice.colour = how.colour;
  if (how.modal) voice.modes = draw_modes(machine);
  voice.noise_seed = stream(seed, recording.situation, 2).bits();
  voice.variation_seed = stream(seed, recording.situation, 3).bits();
  std::vector<int> onsets;
  for (const SimulatedClick& c : recording.clicks) onsets.push_back(c.P);
  recording.clean = render_clicks(voice, recording.clicks, onsets, frames);
  scale(recording.clean,
        kNormalRms * std::pow(10, how.level_db / 20) / rms_within(recording.clean, recording.parts));
}

}  // namespace

SituationRecording simulate_situation(Situation situation, std::uint64_t seed, double seconds) {
  const SituationRecipe how = recipe(situation);
  SplitMix structure = stream(seed, situation, 0);
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
  render(recording, how, seed, static_cast<int>(std::nearbyint(seconds * kAnalysisRate)));

  SplitMix machine(kMachine + 1), noise = stream(seed, situation, 4);
  recording.background =
      background_noise(BackgroundScene::ramp(seconds, how.rpm * 0.97, how.rpm * 1.03), machine, noise);
  scale(recording.background, kBackgroundRms);
  return recording;
}

}  // namespace rigsound::analysis
