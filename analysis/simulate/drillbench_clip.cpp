#include "simulate/drillbench_clip.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/analysis/rate.hpp"
#include "simulate/background_noise.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kDecayDb[] = {40, 20, 10};  // per period
constexpr double kRatesHz[] = {12, 18, 25, 32, 38, 45, 52, 60};
constexpr double kJitters[] = {0.0, 0.03, 0.08, 0.15};
constexpr double kAmplitudeCvs[] = {0.1, 0.2, 0.4, 0.0};
constexpr double kAttackBends[] = {0.0, 3.0, -2.0, 1.5};  // alpha_a N_a

constexpr Bounce kEarlyBounce{0.05, 0.10, 0.3, 0.6}, kLateBounce{0.25, 0.40, 0.4, 0.7};

/// The eight hard clips: what is wrong with the impacts of each.
void make_hard(int hard, ClickProcess& process) {
  const bool all = hard == 7;
  if (hard == 0 || hard == 4 || all) process.bounce = kEarlyBounce;
  if (hard == 1) process.bounce = kLateBounce;
  if (hard == 2 || hard == 5 || all) process.miss = 0.10;
  if (hard == 3 || hard == 6 || all) process.twice = 0.10;
}

/// `row` is the line of the parameter table, `id` what the remaining choices hang on.
ClickProcess process_of(int row, int id) {
  ClickProcess process;
  process.F0 = kRatesHz[row % 8];
  process.jitter = kJitters[(row / 2 + row / 8) % 4];
  process.amplitude_cv = kAmplitudeCvs[(row / 3) % 4];
  process.amplitude_rho = (id / 5) % 2 == 0 ? 0.0 : 0.5;
  process.metronome = id % 3 == 2;
  if (row >= 24) make_hard(row - 24, process);
  return process;
}

ClickEnvelope draw_envelope(int row, int id, double T0, SplitMix& stream) {
  ClickEnvelope envelope;
  envelope.attack_samples = std::min(std::nearbyint(stream.log_uniform(8, 240)), std::floor(0.25 * T0));
  envelope.attack_bend = kAttackBends[id % 4] / envelope.attack_samples;
  envelope.decay = std::log(10.0) * kDecayDb[(row + row / 3) % 3] / 20 / T0;
  return envelope;
}

double rms(const std::vector<double>& x) {
  double energy = 0;
  for (const double v : x) energy += v * v;
  return std::sqrt(energy / static_cast<double>(x.size()));
}

}  // namespace

bool drillbench_id(int id) { return id >= 0 && id % 100 < 32; }

DrillBenchClip drillbench_clip(int id, double seconds, double rate_factor) {
  const int row = id % 100;
  const double nominal_seconds = seconds * rate_factor;
  const auto seed = static_cast<std::uint64_t>(id);
  SplitMix structure(1000 + seed);

  const ClickProcess process = process_of(row, id);
  DrillBenchClip clip;
  clip.T0 = process.T0();
  clip.envelope = draw_envelope(row, id, clip.T0, structure);
  clip.clicks = draw_clicks(process, nominal_seconds, structure);

  ClickVoice voice;
  voice.envelope = clip.envelope;
  voice.noise_seed = 2000 + seed, voice.variation_seed = 3000 + seed;
  voice.colour = draw_colour(structure);
  std::vector<Mode> modes = draw_modes(structure);
  if ((row + row / 8) % 2 == 1) voice.modes = std::move(modes);

  std::vector<int> onsets;
  for (const SimulatedClick& c : clip.clicks) onsets.push_back(c.P);
  const auto frames_of = [](double s) { return static_cast<int>(std::nearbyint(s * kAnalysisRate)); };
  clip.clean = render_clicks(voice, clip.clicks, onsets, frames_of(nominal_seconds));
  const double scale = 1 / rms(clip.clean);

  if (rate_factor != 1) {
    const int frames = frames_of(seconds);
    for (int& P : onsets) P = static_cast<int>(std::nearbyint(P / rate_factor));
    clip.clean = render_clicks(voice, clip.clicks, onsets, frames);
    for (std::size_t i = 0; i < onsets.size(); ++i) clip.clicks[i].P = onsets[i];
    while (!clip.clicks.empty() && clip.clicks.back().P >= frames) clip.clicks.pop_back();
  }
  for (double& v : clip.clean) v *= scale;
  return clip;
}

std::vector<double> drillbench_background(int id, double seconds) {
  const auto seed = static_cast<std::uint64_t>(id);
  SplitMix structure(5000 + seed), noise(6000 + seed);
  return background_noise(BackgroundScene::drawn(seconds, structure), structure, noise);
}

}  // namespace rigsound::analysis
