#include "scene/boom_scene.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "scene/bank_choice.hpp"

namespace rigsound::scene {
namespace {

using drill::Voicing;

// After its burst, open rattling falls to its lasting level with this time constant.
constexpr double kBurstFall_s = 0.08;
// A smoothed feed or rod count this near its target has arrived.
constexpr double kArrived_bar = 0.01, kArrived_rods = 0.005;
// How much louder than a mean impact a rod breaks.
constexpr double kSnap = 6;
// Share of a rod outside the hole where no bus says how far it is in.
constexpr double kExposed = 0.5;
constexpr double kDbPerNeper = 20 / dsp::kLn10;

Voicing voicing_of(Situation s) noexcept {
  return s == Situation::kClosedRattling ? Voicing::kClosedRattling
         : s == Situation::kOpenRattling ? Voicing::kOpenRattling
                                         : Voicing::kDrilling;
}

double rod_length_of(const BoomOptions& boom, const SoundSet& sounds) noexcept {
  return boom.drill_string >= 0 ? sounds.strings[boom.drill_string].rod_length_m : 0.0;
}

/// Towards `target`, and there once it is near; returns whether it moved.
bool approach(double& value, double target, double remainder, double arrived) noexcept {
  if (value == target) return false;
  value = dsp::approached(value, target, remainder);
  if (std::fabs(value - target) < arrived) value = target;
  return true;
}

}  // namespace

BoomScene::BoomScene(const EngineOptions& options, const ClickSpectra& spectra, int index)
    : sounds_(&spectra.sounds()),
      sample_rate_(options.sample_rate),
      points_(feed_points(options.scene)),
      axis_(spectra, options.scene, options.booms[index].drill_string),
      crossfade_step_(std::min(1.0, kChunk / (options.scene.crossfade_s * options.sample_rate))),
      feed_remainder_(dsp::one_pole_remainder(options.scene.response_s, kChunk, options.sample_rate)),
      rods_remainder_(dsp::one_pole_remainder(options.scene.crossfade_s, kChunk, options.sample_rate)),
      burst_chunks_(options.scene.open_burst_s * options.sample_rate / kChunk),
      sustain_gain_(dsp::gain_of_db(options.scene.open_sustain_db)),
      burst_fall_(dsp::one_pole_remainder(kBurstFall_s, kChunk, options.sample_rate)),
      rule_(options.scene),
      contact_bar_(options.scene.contact_bar),
      rod_length_m_(rod_length_of(options.booms[index], *sounds_)) {
  set(BoomState{});
  power_[static_cast<int>(voicing_of(rule_.situation()))] = 1;
}

void BoomScene::set(const BoomState& state) noexcept {
  const bool opens = state.rattling == Rattling::kOpen && state_.rattling != Rattling::kOpen;
  snap_ = snap_ || (state.rod_broken == RodBroken::kYes && state_.rod_broken == RodBroken::kNo);
  state_ = state;
  rule_.update(state);
  if (opens) burst_left_ = burst_chunks_, burst_gain_ = 1;
  tool_.rods = state.rod_count;
  set_string(state);
  moved_ = true;
  place_rattling(Voicing::kClosedRattling, Situation::kClosedRattling);
  place_rattling(Voicing::kOpenRattling, Situation::kOpenRattling);
}

void BoomScene::set_string(const BoomState& state) noexcept {
  const int rocks = static_cast<int>(sounds_->rocks.size());
  const double in_hole_m = static_cast<double>(state.feed_position_m);
  string_.rods = state.rod_count;
  string_.rock_stiffness = (state.rock < rocks ? sounds_->rocks[state.rock] : Rock{}).stiffness;
  string_.exposed_m = in_hole_m >= 0 ? std::max(0.0, rod_length_m_ - in_hole_m) : kExposed * rod_length_m_;
  string_.broken = state.rod_broken == RodBroken::kYes;
}

void BoomScene::place_rattling(Voicing voicing, Situation situation) noexcept {
  drill::Slot& slot = drill_.slots[static_cast<int>(voicing)];
  slot.banks = {};
  slot.controls = state_.controls;
  const BankUse* use = choose_bank(*sounds_, situation, state_.rod_count, state_.rock);
  rattling_[static_cast<int>(voicing)] = use;
  if (use != nullptr) slot.banks.add(sounds_->banks[use->bank], 1);
}

/// A parted string has nothing to press against.
void BoomScene::follow_feed() noexcept {
  const bool broken = state_.rod_broken == RodBroken::kYes;
  const double feed = broken ? 0.0 : static_cast<double>(state_.feed_pressure_bar);
  const bool fed = approach(feed_, feed, feed_remainder_, kArrived_bar);
  const bool added = approach(rods_, state_.rod_count, rods_remainder_, kArrived_rods);
  moved_ = moved_ || fed || added;
}

void BoomScene::place_drilling() noexcept {
  place_ = axis_.place(feed_, rods_, state_.rock);
  // The bit touches the rock over the contact threshold and is pressed on fully at overfeed.
  string_.contact = std::clamp((feed_ - contact_bar_) / (points_.overfeed - contact_bar_), 0.0, 1.0);
  const double pressure = static_cast<double>(state_.percussion_pressure_bar);
  if (pressure >= 0 && place_.percussion_bar > 0) {
    // Impact energy goes with the percussion pressure, the rate with its root.
    const double ln = 0.5 * dsp::log(std::max(pressure, 1.0) / place_.percussion_bar);
    place_.trend.ln_level += ln;
    place_.trend.ln_gap -= ln;
  }
  drill::Slot& slot = drill_.slots[static_cast<int>(Voicing::kDrilling)];
  slot.banks = place_.banks;
  slot.controls = state_.controls;
  // A bank's level is that of its energy, of which a click that decays faster or sounds duller has less.
  const double ln_level = place_.trend.ln_level + 0.5 * place_.trend.ln_decay - place_.ln_tilted_norm;
  slot.tilt_db_per_octave = place_.trend.tilt_db_per_octave;
  slot.controls.mean_amplitude_db += static_cast<float>(ln_level * kDbPerNeper);
  slot.controls.decay_factor *= static_cast<float>(dsp::exp(place_.trend.ln_decay));
}

/// Equal-power crossfade: the target's power grows linearly, the others keep their proportions, and the
/// powers always sum to one.
void BoomScene::crossfade() noexcept {
  const int target = static_cast<int>(voicing_of(rule_.situation()));
  if (power_[target] == 1) return;
  const double before = power_[target];
  const double after = std::min(1.0, before + crossfade_step_);
  const double others = before < 1 ? (1 - after) / (1 - before) : 0;
  for (int v = 0; v < drill::kVoicings; ++v) power_[v] = v == target ? after : power_[v] * others;
  moved_ = true;
}

double BoomScene::burst_gain() noexcept {
  if (burst_left_ > 0)
    burst_left_ -= 1;
  else
    burst_gain_ = sustain_gain_ + (burst_gain_ - sustain_gain_) * burst_fall_;
  return burst_gain_;
}

impact::Statistics BoomScene::drilling_statistics() const noexcept {
  impact::Statistics blended;
  double total = 0;
  const double rate_hz = static_cast<double>(state_.percussion_rate_hz);
  for (int i = 0; i < place_.banks.count; ++i) {
    const drill::BankChoices::Choice& choice = place_.banks.choice[i];
    total += choice.share;
    blended =
        impact::blend(blended, impact::statistics_of(*choice.bank, sample_rate_, rate_hz, state_.controls),
                      choice.share / total);
  }
  const drill::Trend& trend = place_.trend;
  if (!(rate_hz > 0) && !(state_.controls.mean_frequency_hz > 0))
    blended.mean_gap_samples *= dsp::exp(trend.ln_gap);
  blended.gap_variation = std::max(
      0.0, blended.gap_variation + trend.gap_variation * static_cast<double>(state_.controls.deviation_time));
  blended.amplitude_variation =
      std::max(0.0, blended.amplitude_variation +
                        trend.amplitude_variation * static_cast<double>(state_.controls.deviation_amplitude));
  return blended;
}

void BoomScene::blend_statistics() noexcept {
  statistics_ = {};
  if (!rule_.hammering()) return;
  double total = 0;
  for (int v = 0; v < drill::kVoicings; ++v) {
    const drill::BankChoices& banks = drill_.slots[v].banks;
    if (power_[v] <= 0 || banks.count == 0) continue;
    total += power_[v];
    const auto own =
        v == static_cast<int>(Voicing::kDrilling)
            ? drilling_statistics()
            : impact::statistics_of(*banks.choice[0].bank, sample_rate_,
                                    static_cast<double>(state_.percussion_rate_hz), state_.controls);
    statistics_ = impact::blend(statistics_, own, power_[v] / total);
  }
  if (statistics_.mean_gap_samples > 0) tool_.period = string_.period = statistics_.mean_gap_samples;
}

void BoomScene::describe(BoomView& view) const noexcept {
  view.situation = rule_.situation();
  view.hammering = rule_.hammering();
  view.feed_deviation = static_cast<float>(points_.deviation(feed_));
  view.rods = state_.rod_count;
  view.rock = state_.rock;
  const double gap = statistics_.mean_gap_samples;
  view.impact_rate_hz = gap > 0 ? static_cast<float>(sample_rate_ / gap) : 0.0F;
  view.bank_count = 0;
  const auto add = [&view](const BankUse* use, double share) {
    if (use != nullptr && share > 0)
      view.banks[view.bank_count++] = {use->bank, use->rods, use->rock, static_cast<float>(share)};
  };
  const double drilling = power_[static_cast<int>(Voicing::kDrilling)];
  for (int i = 0; i < place_.banks.count; ++i) add(place_.uses[i], drilling * place_.banks.choice[i].share);
  for (int v = 0; v < drill::kVoicings; ++v) add(rattling_[v], power_[v]);
}

void BoomScene::advance() noexcept {
  crossfade();
  follow_feed();
  const double burst = burst_gain();
  for (int v = 0; v < drill::kVoicings; ++v)
    drill_.slots[v].gain.go_to(std::sqrt(power_[v]) *
                               (v == static_cast<int>(Voicing::kOpenRattling) ? burst : 1.0));
  if (moved_) {
    place_drilling();
    blend_statistics();
  }
  moved_ = false;
  statistics_.snap = snap_ ? kSnap : 0.0;
  snap_ = false;
}

}  // namespace rigsound::scene
