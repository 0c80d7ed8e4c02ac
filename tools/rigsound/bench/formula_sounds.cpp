#include "bench/formula_sounds.hpp"

#include <cmath>
#include <string>

#include "rigsound/default_diesel.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::tools {
namespace {

struct Recipe {
  double rate_hz, decay_s, level;
};
constexpr Recipe kRecipes[kSituationCount] = {
    {38, 0.020, 0.5}, {34, 0.030, 0.35}, {33, 0.012, 0.6}, {21, 0.035, 0.7}, {24, 0.010, 1.2}};

std::vector<float> noise_burst(const dsp::RandomField& random, std::size_t click, double decay, int length) {
  std::vector<double> x(static_cast<std::size_t>(length));
  double energy = 0, envelope = 1;
  for (std::size_t n = 0; n < x.size(); ++n) {
    x[n] = envelope * random.normal(click * 100000 + n, 0);
    envelope *= decay;
    energy += x[n] * x[n];
  }
  std::vector<float> click_samples;
  for (const double v : x) click_samples.push_back(static_cast<float>(v / std::sqrt(energy)));
  return click_samples;
}

ClickBank bank(Situation situation, double sample_rate) {
  const auto s = static_cast<std::size_t>(situation);
  const Recipe& recipe = kRecipes[s];
  ClickBank b;
  b.name = std::string(name(situation));
  b.sample_rate = sample_rate;
  b.mean_gap_samples = sample_rate / recipe.rate_hz;
  b.gap_deviation_samples = 0.05 * b.mean_gap_samples;
  b.mean_amplitude = recipe.level;
  b.amplitude_deviation = 0.2 * b.mean_amplitude;
  b.amplitude_correlation = 0.3;
  b.miss_share = situation == Situation::kUnderfeed ? 0.12 : 0.01;
  b.attack_samples = 20;
  b.decay = 1 / (recipe.decay_s * sample_rate);
  const dsp::RandomField random(7, 100 + s);
  for (std::size_t click = 0; click < 10; ++click)
    b.clicks.push_back(noise_burst(random, click, dsp::exp(-b.decay), static_cast<int>(0.08 * sample_rate)));
  return b;
}

}  // namespace

SoundSet formula_sounds(double sample_rate) {
  SoundSet sounds;
  for (int s = 0; s < kSituationCount; ++s) {
    const auto situation = static_cast<Situation>(s);
    sounds.banks.push_back(bank(situation, sample_rate));
    sounds.uses.push_back({situation, 0, -1, s});
  }
  ToolModel tool;
  tool.name = "steel";
  sounds.tools.push_back(tool);
  sounds.diesels.push_back(default_diesel());
  return sounds;
}

EngineOptions full_options(int block) {
  EngineOptions options;
  options.block = block;
  options.seed = 2015;
  options.booms = {{"left", -0.5, 0, 0}, {"right", 0.5, -3, -1}};
  options.mix.equaliser = {{3000, -2, 0.8}, {120, 3, 0.7}};
  return options;
}

MachineState drilled_hole(double second) {
  const double t = second - 60 * std::floor(second / 60);
  MachineState state;
  state.engine_rpm = t < 2 ? 0 : t < 6 ? 800 : t < 50 ? 1800 : 900;
  BoomState& left = state.boom[0];
  left.feed_pressure_bar = t < 8 ? 0 : t < 16 ? 40 : t < 24 ? 90 : t < 32 ? 150 : t < 38 ? 90 : 0;
  if (t >= 40 && t < 46) left.rattling = Rattling::kClosed;
  if (t >= 46 && t < 50) left.rattling = Rattling::kOpen;
  left.percussion_rate_hz = t >= 20 && t < 24 ? 45 : 0;
  BoomState& right = state.boom[1];
  right.feed_pressure_bar = t > 12 && t < 30 ? 100 : 0;
  right.controls.decay_factor = t > 20 ? 2 : 1;
  right.controls.attack_factor = t > 25 ? 1.5f : 1;
  state.master_gain_db = t > 55 ? -6 : 0;
  return state;
}

}  // namespace rigsound::tools
