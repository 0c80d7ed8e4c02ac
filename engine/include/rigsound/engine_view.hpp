// Why it sounds like this: what the engine made of the machine's state, block by block.
#pragma once

#include <array>
#include <cstdint>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound {

/// A layer in the last block, linear, full scale 1: after its gain and its boom's, before pan, equaliser,
/// output level and limiter.
struct LayerLevel {
  float peak = 0, rms = 0;
};

/// A bank that sounds, and what it was recorded with.
struct BankShare {
  int bank = 0;   ///< index into SoundSet::banks
  int rods = 0;   ///< 0: any
  int rock = -1;  ///< index into SoundSet::rocks; -1: any
  float share =
      0;  ///< while drilling how likely an impact draws it, in a crossfade its share of the power too
};
constexpr int kMaxBankShares = 6;  ///< two rod counts at two feeds, and two kinds of rattling

/// One drill. Plain data.
struct BoomView {
  Situation situation = Situation::kUnderfeed;
  bool hammering = false;
  float feed_deviation =
      0;  ///< of the smoothed feed: -1 underfeed bank, 0 normal, +1 overfeed bank, and beyond
  int rods = 1, rock = 0;                         ///< asked for; `rock` may be none of the sound set
  std::array<BankShare, kMaxBankShares> banks{};  ///< shares add up to 1
  int bank_count = 0;
  float impact_rate_hz = 0;   ///< wanted, missed and double strikes apart; 0: the hammer rests
  float impacts_made_hz = 0;  ///< counted over the last second of sound
  LayerLevel drill, tool;     ///< tool: the bar or the drill string
};

/// Plain data. Thread: RT (the thread that calls process).
struct EngineView {
  std::array<BoomView, kMaxBooms> boom{};  ///< of the rig's booms; the rest stay as they are here
  LayerLevel diesel;
  bool stands_still = false;  ///< the simulator is paused, or back at its start, and the sound has faded
};

}  // namespace rigsound
