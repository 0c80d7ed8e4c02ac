#include "tool/tool_layer.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

constexpr double kFade_s = 0.020;
constexpr double kGainRamp_s = 0.010;          // a gain goes from 0 to 1 in this time
constexpr double kReflectionSlope_per_s = 30;  // faster ramps of k are heard as noise above 12 kHz
constexpr double kMaxReflection = 0.9999;

/// Reflections times a factor, kept below 1.
void scale(const double* k, const double* factor, double* out) noexcept {
  for (int n = 0; n < kChunk; ++n) out[n] = std::min(kMaxReflection, k[n] * factor[n]);
}

double smoothstep(double x) noexcept { return x * x * (3 - 2 * x); }

}  // namespace

ToolLayer::ToolLayer(const ToolModel& model, double sample_rate, std::uint64_t seed, int boom,
                     dsp::LaneWidth width)
    : model_(model),
      sample_rate_(sample_rate),
      width_(width),
      strikes_(model.strike, sample_rate, seed, boom),
      fade_step_(1 / (kFade_s * sample_rate)),
      amplitude_(1, 1 / (kGainRamp_s * sample_rate)),
      k_T_(1, kReflectionSlope_per_s / sample_rate),
      k_L_(1, kReflectionSlope_per_s / sample_rate),
      mix_T_(weight_T(), weight_T() / (kGainRamp_s * sample_rate)),
      mix_L_(weight_L(), weight_L() / (kGainRamp_s * sample_rate)) {
  designs_.push_back(design_for(model, sample_rate));
  for (const RodSteel& rod : model.rods) {
    ToolModel other = model;
    other.bar = rod.bar;
    designs_.push_back(design_tool(other, sample_rate));
  }
  steels_.assign(2, steel_of(designs_.front()));
  for (const ToolBand& band : model.voicing.equaliser)
    equaliser_.emplace_back(dsp::peaking(band.frequency_hz, band.gain_db, band.q, sample_rate));
}

ToolLayer::Steel ToolLayer::steel_of(const ToolDesign& design) const noexcept {
  Steel steel{BarLoops(design, model_.voicing.highpass_hz, width_),
              Contact(design.transversal, model_.strike, sample_rate_),
              {}};
  steel.k_L.fill(design.longitudinal.reflection_max);
  return steel;
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

void ToolLayer::follow(const ToolInput& input) noexcept {
  amplitude_.process(input.amplitude);
  k_T_.process(input.transversal_reflection);
  k_L_.process(input.longitudinal_reflection);
  mix_T_.process(weight_T() * input.transversal_mix);
  mix_L_.process(weight_L() * input.longitudinal_mix);
}

void ToolLayer::strike(const Impacts& impacts, double period) noexcept {
  drive_.struck = strikes_.process(impacts, period, x_);
  if (!amplitude_.rests_at(1))
    for (int n = 0; n < kChunk; ++n) x_[n] *= amplitude_.curve()[n];
}

void ToolLayer::ring(Steel& steel, double* out) noexcept {
  double k_T[kChunk], k_L[kChunk];
  steel.contact.process(strikes_, k_T);
  if (!k_T_.rests_at(1)) scale(k_T, k_T_.curve(), k_T);
  if (!k_L_.rests_at(1)) scale(steel.k_L.data(), k_L_.curve(), k_L);
  drive_.x = x_;
  drive_.k[kTransversal] = k_T, drive_.k[kLongitudinal] = k_L_.rests_at(1) ? steel.k_L.data() : k_L;
  drive_.mix[kTransversal] = mix_T_.curve(), drive_.mix[kLongitudinal] = mix_L_.curve();
  steel.loops.process(drive_, out);
}

void ToolLayer::crossfade(double* out) noexcept {
  double next[kChunk];
  ring(steels_[1 - ringing_], next);
  for (int n = 0; n < kChunk; ++n) {
    out[n] += smoothstep(fade_) * (next[n] - out[n]);
    fade_ = std::min(1.0, fade_ + fade_step_);
  }
  if (fade_ < 1) return;
  ringing_ = 1 - ringing_;
  fade_ = 0;
}

void ToolLayer::equalise(double* out) noexcept {
  for (dsp::Biquad& band : equaliser_) {
    band.process(out, kChunk);
    band.settle();
  }
}

bool ToolLayer::rests() const noexcept {
  const Steel& steel = steels_[ringing_];
  return strikes_.rests() && fade_ == 0 && steel.loops.asleep() && steel.contact.rests() &&
         std::all_of(equaliser_.begin(), equaliser_.end(), [](const dsp::Biquad& b) { return b.rests(); });
}

void ToolLayer::reset() noexcept {
  strikes_.reset();
  for (Steel& steel : steels_) steel.loops.reset();
  for (dsp::Biquad& band : equaliser_) band.reset();
}

bool ToolLayer::process(const ToolInput& input, const Impacts& impacts, double* out) noexcept {
  follow_rods(input.rods);
  begin_fade();
  follow(input);
  if (impacts.count == 0 && rests()) {
    std::fill(out, out + kChunk, 0.0);
    return false;
  }
  strike(impacts, input.period);
  ring(steels_[ringing_], out);
  if (fade_ > 0) crossfade(out);
  equalise(out);
  return true;
}

}  // namespace rigsound::tool
