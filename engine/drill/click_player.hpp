// The clicks of one bank at a time, one for every blow.
#pragma once

#include <array>
#include <cstdint>

#include "drill/click_voice.hpp"
#include "drill/drill_input.hpp"
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

  /// Players with different (seed, boom, voicing) choose independently. Thread: OFF.
  ClickPlayer(std::uint64_t seed, int boom, int voicing) noexcept;

  /// Draws a bank, which must outlive the player, and a voice takes a click of it. When every voice is busy
  /// the click is counted as lost. Thread: RT.
  void strike(const BankChoices& banks, const Impact& impact, const DrillControls& controls) noexcept;

  bool sounds() const noexcept { return sounding_ != 0; }  ///< any click does

  /// Adds kChunk samples of all sounding clicks to `bus`. Thread: RT.
  void add_to(double* bus) noexcept;

  void reset() noexcept { sounding_ = 0; }  ///< No click sounds any more. Thread: RT

  std::uint64_t lost() const noexcept { return lost_; }

 private:
  /// The last clicks played of one bank.
  struct Rest {
    const ClickBank* bank = nullptr;
    std::array<std::size_t, kMaxResting> click{};  ///< oldest first
    std::size_t count = 0;

    void add(std::size_t played) noexcept;
    std::size_t up_to(std::size_t played) const noexcept;
  };

  Rest& rest_of(const ClickBank& bank) noexcept;
  const Click& choose(const ClickBank& bank, std::uint64_t index) noexcept;

  dsp::RandomField random_;
  std::array<ClickVoice, kMaxVoices> voices_{};
  std::uint64_t sounding_ = 0;  ///< a bit for each voice
  static_assert(kMaxVoices == 64);
  std::array<Rest, kMaxChoices> rests_{};
  std::size_t next_rest_ = 0;  ///< taken by the next bank that has none
  std::uint64_t lost_ = 0;
};

}  // namespace rigsound::drill
