#include "tool/tool_layer.hpp"

#include <algorithm>

#include "dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

constexpr double kFade_s = 0.020;
constexpr double kGainRamp_s = 0.010;          // a gain goes from 0 to 1 in this time
constexpr double kReflectionSlope_per_s = 60;  // faster ramps of k are heard as noise above 12 kHz
constexpr double kMaxReflection = 0.9999;

double smoothstep(double x) noexcept { return x * x * (3 - 2 * x); }

}  // namespace

double ToolLayer::Ramp::next(double target) noexcept {
  value = value < target ? std::min(target, value + step) : std::max(target, value - step);
  return value;
}

ToolLayer::ToolLayer(const ToolModel& model, double sample_rate, std::uint64_t seed, int boom,
                     LaneWidth width)
    : model_(model),
      sample_rate_(sample_rate),
      width_(width),
      strikes_(model.strike, sample_rate, seed, boom),
      fade_step_(1 / (kFade_s * sample_rate)) {
  designs_.push_back(design_for(model, sample_rate));
  for (const RodSteel& rod : model.rods) {
    ToolModel other = model;
    other.bar = rod.bar;
    other.designs.clear();
    designs_.push_back(design_tool(other, sample_rate));
  }
  steels_.assign(2, steel_of(designs_.front()));
  for (const ToolBand& band : model.voicing.equaliser)
    equaliser_.emplace_back(dsp::peaking(band.frequency_hz, band.gain_db, band.q, sample_rate));
  for (Ramp* gain : {&amplitude_, &mix_T_, &mix_L_}) gain->step = 1 / (kGainRamp_s * sample_rate);
  for (Ramp* reflection : {&k_T_, &k_L_}) reflection->step = kReflectionSlope_per_s / sample_rate;
}

ToolLayer::Steel ToolLayer::steel_of(const ToolDesign& design) const noexcept {
  return {BarLoops(design, model_.voicing.highpass_hz, width_),
          Contact(design.transversal, model_.strike, sample_rate_), design.longitudinal.k_max};
}

void ToolLayer::change(const ToolDesign& design) noexcept {
  wanted_ = design;
  change_waits_ = true;
}

void ToolLayer::follow_rods(int rods) noexcept {
  std::size_t choice = 0;
  for (std::size_t i = 0; i < model_.rods.size(); ++i)
    if (model_.rods[i].rods == rods) choice = i + 1;
  if (choice == chosen_) return;
  chosen_ = choice;
  change(designs_[choice]);
}

void ToolLayer::begin_fade() noexcept {
  if (!change_waits_ || fade_ > 0) return;
  change_waits_ = false;
  steels_[1 - ringing_] = steel_of(wanted_);
  fade_ = fade_step_;
}

void ToolLayer::drive(const Excitation& excitation, const ToolControls& controls) noexcept {
  const ToolVoicing& voicing = model_.voicing;
  for (int n = 0; n < kChunk; ++n) {
    drive_.x[n] = excitation.x[n] * amplitude_.next(controls.amplitude);
    factor_T_[n] = k_T_.next(controls.k_T);
    factor_L_[n] = k_L_.next(controls.k_L);
    drive_.mix[n][kTransversal] = voicing.level * voicing.mix_T * mix_T_.next(controls.mix_T);
    drive_.mix[n][kLongitudinal] = voicing.level * voicing.mix_L * mix_L_.next(controls.mix_L);
  }
}

void ToolLayer::ring(Steel& steel, const Excitation& excitation, double* out) noexcept {
  double k_T[kChunk];
  steel.contact.process(excitation.slope, k_T);
  for (int n = 0; n < kChunk; ++n) {
    drive_.k[n][kTransversal] = std::min(kMaxReflection, k_T[n] * factor_T_[n]);
    drive_.k[n][kLongitudinal] = std::min(kMaxReflection, steel.k_L * factor_L_[n]);
  }
  steel.loops.process(drive_, out);
}

void ToolLayer::crossfade(const Excitation& excitation, double* out) noexcept {
  double next[kChunk];
  ring(steels_[1 - ringing_], excitation, next);
  for (int n = 0; n < kChunk; ++n) {
    out[n] += smoothstep(fade_) * (next[n] - out[n]);
    fade_ = std::min(1.0, fade_ + fade_step_);
  }
  if (fade_ < 1) return;
  ringing_ = 1 - ringing_;
  fade_ = 0;
}

void ToolLayer::process(const Impact* impacts, int count, const ToolControls& controls,
                        double* out) noexcept {
  follow_rods(controls.rods);
  begin_fade();
  Excitation excitation;
  strikes_.process(impacts, count, controls.period, excitation);
  drive(excitation, controls);
  ring(steels_[ringing_], excitation, out);
  if (fade_ > 0) crossfade(excitation, out);
  for (dsp::Biquad& band : equaliser_)
    for (int n = 0; n < kChunk; ++n) out[n] = band.process(out[n]);
}

}  // namespace rigsound::tool
