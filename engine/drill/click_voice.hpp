// One click sounding.
#pragma once

#include "drill/attack_decay.hpp"
#include "rigsound/click.hpp"
#include "rigsound/click_bank.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound::drill {

class ClickVoice {
 public:
  /// Starts `click` of `bank` at `delay` samples into the next chunk. The attack and decay factors of
  /// `controls` are those of this moment and stay with the click. Thread: RT.
  void start(const ClickBank& bank, const Click& click, int delay, double gain,
             const DrillControls& controls) noexcept;

  /// Adds the next kChunk samples to `bus`. Thread: RT.
  void add_to(double* bus) noexcept;

  bool sounding() const noexcept { return position_ != end_; }

 private:
  /// What the next sample is multiplied by to turn the bank's envelope into the wanted one.
  double next_ratio() noexcept;

  const float* position_ = nullptr;
  const float* end_ = nullptr;
  int delay_ = 0;
  double gain_ = 0;
  bool reshaped_ = false;
  AttackDecay was_, wanted_;  ///< the click is multiplied by wanted / was
  double ratio_ = 1;
};

}  // namespace rigsound::drill
