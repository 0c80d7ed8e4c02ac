#include "rigsound/refined_bank.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drill/click_voice.hpp"

namespace rigsound {
namespace {

/// The click as a voice plays it.
std::vector<double> heard(const ClickBank& bank, const Click& click, const DrillControls& controls) {
  const std::size_t chunks = (click.size() + kChunk - 1) / kChunk;
  std::vector<double> sound(chunks * kChunk, 0.0);
  drill::ClickVoice voice;
  voice.start(bank, click, 0, 1, controls);
  for (std::size_t c = 0; c < chunks; ++c) voice.add_to(&sound[c * kChunk]);
  sound.resize(click.size());
  return sound;
}

/// Reshapes all clicks; their mean square norm.
double reshape(const ClickBank& bank, const DrillControls& controls, std::vector<Click>& clicks) {
  double mean = 0;
  for (Click& click : clicks) {
    const std::vector<double> sound = heard(bank, click, controls);
    double energy = 0;
    for (const double x : sound) energy += x * x;
    mean += energy / static_cast<double>(clicks.size());
    const double scale = energy > 0 ? 1 / std::sqrt(energy) : 0;
    std::vector<float> reshaped(sound.size());
    std::transform(sound.begin(), sound.end(), reshaped.begin(),
                   [scale](double x) { return static_cast<float>(scale * x); });
    click = std::move(reshaped);
  }
  return mean;
}

}  // namespace

ClickBank refined_bank(const ClickBank& bank, const DrillControls& controls) {
  ClickBank refined = bank;
  const double gap_variation =
      bank.gap_deviation_samples / bank.mean_gap_samples * static_cast<double>(controls.deviation_time);
  if (controls.mean_frequency_hz > 0)
    refined.mean_gap_samples = bank.sample_rate / static_cast<double>(controls.mean_frequency_hz);
  refined.gap_deviation_samples = gap_variation * refined.mean_gap_samples;
  refined.gain_db += static_cast<double>(controls.mean_amplitude_db);
  refined.amplitude_deviation *= static_cast<double>(controls.deviation_amplitude);
  const double attack = static_cast<double>(controls.attack_factor),
               decay = static_cast<double>(controls.decay_factor);
  if (attack != 1 || decay != 1) {
    const double norm = std::sqrt(reshape(bank, controls, refined.clicks));
    refined.mean_amplitude *= norm;
    refined.amplitude_deviation *= norm;
    refined.attack_samples *= attack;
    refined.attack_bend /= attack;
    refined.decay *= decay;
  }
  require_valid(refined);
  return refined;
}

}  // namespace rigsound
