// A bank whose one click is the envelope itself.
#pragma once

#include <vector>

#include "drill/attack_decay.hpp"
#include "drill/click_player.hpp"
#include "rigsound/click_bank.hpp"

namespace rigsound {

inline ClickBank flat_bank(double N_a, double alpha_d) {
  ClickBank bank;
  bank.mean_gap_samples = 4800, bank.mean_amplitude = 2, bank.attack_samples = N_a, bank.decay = alpha_d;
  std::vector<float> click;
  drill::AttackDecay envelope(N_a, 0, alpha_d);
  for (int n = 0; n < 2000; ++n) click.push_back(static_cast<float>(envelope.next()));
  bank.clicks = {click};
  return bank;
}

/// 3200 samples after one blow of amplitude 1.5.
inline std::vector<double> one_strike(const ClickBank& bank, double onset, const DrillControls& controls) {
  drill::ClickPlayer player(1, 0, 0);
  player.strike(bank, {onset, 1.5, 0}, controls);
  std::vector<double> out(3200, 0.0);
  for (std::size_t n = 0; n < out.size(); n += kChunk) player.add_to(&out[n]);
  return out;
}

}  // namespace rigsound
