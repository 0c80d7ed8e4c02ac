#include "drill/click_voice.hpp"

#include <algorithm>
#include <cstddef>

#include "rigsound/dsp/passes.hpp"

namespace rigsound::drill {
namespace {

// A bent attack made shorter would need boundless gain at its first samples, where there is little but noise.
// A straight one needs 1 / factor, 20 dB at most.
constexpr double kMaxAttackGain = 10;
// A click ends 60 dB down. Made longer, its end is still 30 dB down and nobody hears it stop.
constexpr double kMaxDecayGain = 31.6;
constexpr double kSilence = 1e-9;

}  // namespace

double ClickVoice::next_ratio() noexcept {
  const double limit = was_.decaying() ? kMaxDecayGain : kMaxAttackGain;
  const double was = was_.next();
  const double wanted = wanted_.next();
  if (was > kSilence) ratio_ = std::min(wanted / was, limit);
  return ratio_;
}

void ClickVoice::start(const ClickBank& bank, const Click& click, int delay, double gain,
                       const DrillControls& controls) noexcept {
  position_ = click.data();
  end_ = click.data() + click.size();
  delay_ = delay;
  gain_ = gain;
  const double attack = static_cast<double>(controls.attack_factor);
  const double decay = static_cast<double>(controls.decay_factor);
  reshaped_ = attack != 1 || decay != 1;
  if (!reshaped_) return;
  was_ = AttackDecay(bank.attack_samples, bank.attack_bend, bank.decay);
  wanted_ = AttackDecay(bank.attack_samples * attack, bank.attack_bend / attack, bank.decay * decay);
  // Both envelopes are 0 at their first sample; their ratio there is taken from the second.
  const AttackDecay was = was_, wanted = wanted_;
  ratio_ = 1;
  next_ratio(), next_ratio();
  was_ = was, wanted_ = wanted;
}

void ClickVoice::add_to(double* bus) noexcept {
  const int from = std::min(delay_, kChunk);
  delay_ -= from;
  const int count = static_cast<int>(std::min<std::ptrdiff_t>(kChunk - from, end_ - position_));
  double* out = bus + from;
  if (!reshaped_)
    dsp::with_widest<dsp::Passes>([&](auto passes) { passes.add_scaled(gain_, position_, count, out); });
  else
    for (int n = 0; n < count; ++n) out[n] += gain_ * next_ratio() * static_cast<double>(position_[n]);
  position_ += count;
}

}  // namespace rigsound::drill
