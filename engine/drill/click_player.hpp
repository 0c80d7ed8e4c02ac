// The clicks of one bank at a time, one for every blow.
#pragma once

#include <array>
#include <cstdint>

#include "drill/click_voice.hpp"
#include "dsp/random.hpp"
#include "rigsound/click_bank.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/limits.hpp"

namespace rigsound::drill {

/// Plays a click for each impact: chosen at random, never the same twice in a row (granular.md, step 9),
/// at the impact's rounded onset, with the impact's amplitude times the bank's B.
class ClickPlayer {
 public:
  /// Players with different (seed, boom, situation) choose independently. Thread: OFF.
  ClickPlayer(std::uint64_t seed, int boom, int situation) noexcept;

  /// A voice takes a click of `bank`, which must outlive it. When every voice is busy the click is
  /// counted as lost. Thread: RT.
  void strike(const ClickBank& bank, const Impact& impact, const DrillControls& controls) noexcept;

  /// Adds kChunk samples of all sounding clicks to `bus`; returns whether any sounded. Thread: RT.
  bool add_to(double* bus) noexcept;

  std::uint64_t lost() const noexcept { return lost_; }

 private:
  const std::vector<float>& choose(const ClickBank& bank, std::uint64_t index) noexcept;

  dsp::RandomField random_;
  std::array<ClickVoice, kMaxVoices> voices_{};
  const std::vector<float>* last_ = nullptr;
  std::uint64_t lost_ = 0;
};

}  // namespace rigsound::drill
