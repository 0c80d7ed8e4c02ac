#include "scene/boom_scene.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"
#include "scene/bank_choice.hpp"

namespace rigsound::scene {
namespace {

// After its burst, open rattling falls to its lasting level with this time constant.
constexpr double kBurstFall_s = 0.08;

constexpr auto kOpen = static_cast<std::size_t>(Situation::kOpenRattling);

}  // namespace

BoomScene::BoomScene(const EngineOptions& options, const SoundSet& sounds) noexcept
    : sounds_(sounds),
      sample_rate_(options.sample_rate),
      crossfade_step_(options.scene.crossfade_s > 0
                          ? std::min(1.0, kChunk / (options.scene.crossfade_s * options.sample_rate))
                          : 1.0),
      burst_chunks_(options.scene.open_burst_s * options.sample_rate / kChunk),
      sustain_gain_(dsp::gain_of_db(options.scene.open_sustain_db)),
      burst_fall_(dsp::one_pole_remainder(kBurstFall_s, kChunk, options.sample_rate)),
      rule_(options.scene) {
  latch(BoomState{});
  power_[static_cast<std::size_t>(rule_.situation())] = 1;
}

void BoomScene::latch(const BoomState& state) noexcept {
  const bool opens = state.rattling == Rattling::kOpen && state_.rattling != Rattling::kOpen;
  state_ = state;
  rule_.update(state);
  if (opens) burst_left_ = burst_chunks_, burst_gain_ = 1;
  drill_.controls = state.controls;
  tool_.rods = state.rod_count;
  for (std::size_t i = 0; i < drill_.slots.size(); ++i)
    drill_.slots[i].bank = choose_bank(sounds_, static_cast<Situation>(i), state.rod_count, state.rock);
}

/// Equal-power crossfade: the target's power grows linearly, the others keep their proportions, and the
/// powers always sum to one.
void BoomScene::crossfade() noexcept {
  const auto target = static_cast<std::size_t>(rule_.situation());
  const double before = power_[target];
  const double after = std::min(1.0, before + crossfade_step_);
  const double others = before < 1 ? (1 - after) / (1 - before) : 0;
  for (std::size_t i = 0; i < power_.size(); ++i) power_[i] = i == target ? after : power_[i] * others;
}

double BoomScene::burst_gain() noexcept {
  if (burst_left_ > 0)
    burst_left_ -= 1;
  else
    burst_gain_ = sustain_gain_ + (burst_gain_ - sustain_gain_) * burst_fall_;
  return burst_gain_;
}

void BoomScene::blend_statistics() noexcept {
  statistics_ = {};
  if (!rule_.hammering()) return;
  double total = 0;
  for (std::size_t i = 0; i < drill_.slots.size(); ++i) {
    const ClickBank* const bank = drill_.slots[i].bank;
    if (power_[i] <= 0 || !bank) continue;
    total += power_[i];
    const auto own = impact::statistics_of(*bank, sample_rate_,
                                           static_cast<double>(state_.percussion_rate_hz), state_.controls);
    statistics_ = impact::blend(statistics_, own, power_[i] / total);
  }
}

void BoomScene::advance() noexcept {
  crossfade();
  const double burst = burst_gain();
  for (std::size_t i = 0; i < drill_.slots.size(); ++i)
    drill_.slots[i].gain.go_to(std::sqrt(power_[i]) * (i == kOpen ? burst : 1.0));
  blend_statistics();
  if (statistics_.mean_gap_samples > 0) tool_.period = statistics_.mean_gap_samples;
}

}  // namespace rigsound::scene
