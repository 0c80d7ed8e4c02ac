#include "string/string_layer.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "string/design/string_tuning.hpp"

namespace rigsound::string {
namespace {

constexpr double kFade_s = 0.020;
constexpr double kContactRamp_s = 0.020;                  // from 0 to 1
constexpr double kLoading_s = 0.020, kExposed_s = 0.050;  // time constants
constexpr double kJump_m = 0.3;      // of the exposed length: a rod was added or taken off
constexpr double kReturn_s = 0.005;  // of the bit into its gap
constexpr double kSnap_s = 60e-6;
constexpr double kSilentEnergy = 1e-24, kNearSilent = 1e-9;  // the latter of the output
constexpr int kQuietChunks = 64;

Strike strike_of(const StringModel& model) {
  Strike strike;
  strike.width_s = model.strike_width_s;
  strike.amplitude_variation = model.amplitude_variation;
  strike.bounces = model.bounces;
  strike.gap_min = 0.8 * model.bounce_gap, strike.gap_max = 1.2 * model.bounce_gap;
  strike.ratio_min = 0.7 * model.bounce_ratio, strike.ratio_max = std::min(1.0, 1.3 * model.bounce_ratio);
  return strike;
}

const StringModel& checked(const StringModel& model) {
  require_valid(model);
  return model;
}

double smoothstep(double x) noexcept { return x * x * (3 - 2 * x); }

}  // namespace

StringLayer::StringLayer(const StringModel& model, double sample_rate, std::uint64_t seed, int boom,
                         dsp::LaneWidth width)
    : model_(checked(model)),
      impedance_(rod_impedance(model) * sample_rate),
      width_samples_(model.strike_width_s * sample_rate),
      contact_step_(kChunk / (kContactRamp_s * sample_rate)),
      loading_left_(dsp::one_pole_remainder(kLoading_s, kChunk, sample_rate)),
      exposed_left_(dsp::one_pole_remainder(kExposed_s, kChunk, sample_rate)),
      fade_step_(1 / (kFade_s * sample_rate)),
      kernel_(string_kernel(width)),
      strikes_(strike_of(model), sample_rate, seed, boom),
      string_(model, sample_rate, width),
      bending_(model, sample_rate, width),
      rods_(model.rods),
      exposed_m_(model.rod_length_m),
      loading_samples_(impedance_ / StringInput{}.rock_stiffness) {
  string_.bit().set_return(1 / (kReturn_s * sample_rate));
  const double snap = dsp::gain_of_db(model.snap_db), samples = kSnap_s * sample_rate;
  for (int n = 0; n < kChunk && n + 0.5 < samples; ++n)
    snap_pulse_[n] = snap / 2 * (1 - dsp::cos(dsp::kTwoPi * (n + 0.5) / samples));
  const double t = std::sqrt(3.0) * dsp::tan(dsp::kPi * model.highpass_hz / sample_rate);
  voice_.hp_p = (1 - t) / (1 + t);
  voice_.hp_b = (1 + voice_.hp_p) / 2;
  voice_.string_mix = model.level * model.string_mix;
}

void StringLayer::restring(const StringInput& input) noexcept {
  rods_ = input.rods;
  exposed_m_ = std::min(input.exposed_m, model_.rod_length_m);
  broken_ = input.broken;
  string_.restring(rods_);
  if (broken_) string_.part();
  bending_.set(exposed_m_, contact_);
  bending_.retune();
  voice_.hp_x = voice_.hp_y = 0;
  asleep_ = true;
}

void StringLayer::break_rod() noexcept {
  broken_ = true;
  contact_ = 0;
  string_.part();
  std::copy(snap_pulse_, snap_pulse_ + kChunk, snap_);
  snaps_ = true;
}

/// Another string is faded to through silence: its lines and modes have nothing in common with the old one's.
void StringLayer::change_string(const StringInput& input) noexcept {
  if (snaps_) std::fill(snap_, snap_ + kChunk, 0.0), snaps_ = false;
  const double exposed_m = std::min(input.exposed_m, model_.rod_length_m);
  const bool mended = broken_ && !input.broken;
  const bool differs = input.rods != rods_ || mended || std::fabs(exposed_m - exposed_m_) > kJump_m;
  if (differs && fade_ == Fade::kNone) fade_ = Fade::kOut;
  if (fade_ == Fade::kOut && (gain_ == 0 || asleep_)) {
    restring(input);
    fade_ = gain_ < 1 ? Fade::kIn : Fade::kNone;
  }
  if (input.broken && !broken_) break_rod();
}

void StringLayer::follow(const StringInput& input) noexcept {
  if (fade_ != Fade::kOut) {
    const double wanted = std::min(input.exposed_m, model_.rod_length_m);
    exposed_m_ =
        std::fabs(wanted - exposed_m_) < 1e-6 ? wanted : dsp::approached(exposed_m_, wanted, exposed_left_);
  }
  contact_ = dsp::step_towards(contact_, broken_ ? 0 : input.contact, contact_step_);
  loading_samples_ = dsp::approached(loading_samples_, impedance_ / input.rock_stiffness, loading_left_);
  bending_.set(exposed_m_, contact_);
  string_.set_contact(contact_);
  string_.bit().set_loading(loading_samples_);
  // With half the feed a mean blow's pulse just closes the gap.
  string_.bit().set_gap(contact_ > 0 ? width_samples_ * (1 - contact_) / contact_ : -1);
}

void StringLayer::ring(bool struck, double* out) noexcept {
  alignas(32) double bending[kChunk], both[kChunk];
  const double* x = x_;
  if (snaps_) {
    for (int n = 0; n < kChunk; ++n) both[n] = x_[n] + snap_[n];
    x = both;
  }
  string_.process({string_.parted() ? x_ : x, snap_, out});
  bending_.process(x, struck || snaps_, bending);
  kernel_.voice(voice_, bending, out);
}

void StringLayer::apply_fade(double* out) noexcept {
  const double step = fade_ == Fade::kOut ? -fade_step_ : fade_step_;
  for (int n = 0; n < kChunk; ++n) {
    out[n] *= smoothstep(gain_);
    gain_ = std::min(std::max(gain_ + step, 0.0), 1.0);
  }
  if (fade_ == Fade::kIn && gain_ == 1) fade_ = Fade::kNone;
}

void StringLayer::rest_if_silent(bool struck, const double* out) noexcept {
  quiet_ = struck || std::fabs(out[kChunk - 1]) > kNearSilent ? 0 : quiet_ + 1;
  if (quiet_ < kQuietChunks) return;
  quiet_ = 0;
  if (string_.energy() + bending_.energy() <= kSilentEnergy) fall_asleep();
}

void StringLayer::fall_asleep() noexcept {
  string_.silence();
  bending_.silence();
  voice_.hp_x = voice_.hp_y = 0;
  asleep_ = true;
}

void StringLayer::reset() noexcept {
  strikes_.reset();
  fall_asleep();
}

bool StringLayer::process(const StringInput& input, const Impacts& impacts, double* out) noexcept {
  change_string(input);
  follow(input);
  const bool struck = strikes_.process(impacts, input.period, x_);
  const bool sounds = !asleep_ || struck || snaps_;
  if (sounds) {
    if (asleep_) string_.bit().silence(), bending_.retune();
    asleep_ = false;
    ring(struck, out);
    rest_if_silent(struck || snaps_, out);
  } else {
    std::fill(out, out + kChunk, 0.0);
  }
  if (fade_ != Fade::kNone) apply_fade(out);
  return sounds;
}

}  // namespace rigsound::string
