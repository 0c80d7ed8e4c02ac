// The clicks of one bank at a time, one for every blow.
#pragma once

#include <array>
#include <cstdint>

#include "drill/click_voice.hpp"
#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/random.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::drill {

/// Plays a click for each impact: at random one of those that have rested, so never the same twice in a row
/// and all about equally often; at the impact's rounded onset, with the impact's
/// amplitude times the bank's B.
class ClickPlayer {
 public:
  /// A click is not played again before half the others of its bank, or this many, have been.
  static constexpr std::size_t kMaxResting = 8;

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
  void rest(std::size_t click, std::size_t clicks) noexcept;

  dsp::RandomField random_;
  std::array<ClickVoice, kMaxVoices> voices_{};
  const ClickBank* bank_ = nullptr;                 ///< the one resting_ counts in
  std::array<std::size_t, kMaxResting> resting_{};  ///< the last clicks played, oldest first
  std::size_t resting_count_ = 0;
  std::uint64_t lost_ = 0;
};

}  // namespace rigsound::drill
