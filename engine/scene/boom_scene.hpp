// What one boom shall sound like in the next chunk.
#pragma once

#include <array>

#include "impact/impact_train.hpp"
#include "rigsound/engine.hpp"
#include "rigsound/limits.hpp"
#include "scene/feed_rule.hpp"

namespace rigsound::scene {

/// The bank that serves a situation now, and its gain over the chunk.
struct Slot {
  const ClickBank* bank = nullptr;
  double gain_from = 0, gain_to = 0;  ///< linear ramp over kChunk samples
};

class BoomScene {
 public:
  BoomScene(const EngineOptions& options, const SoundSet& sounds) noexcept;

  /// A new state, at a block's start. Thread: RT.
  void latch(const BoomState& state) noexcept;

  /// Moves on by one chunk. Thread: RT.
  void advance() noexcept;

  const std::array<Slot, kSituationCount>& slots() const noexcept { return slots_; }
  const impact::Statistics& statistics() const noexcept { return statistics_; }
  const BoomState& state() const noexcept { return state_; }
  bool hammering() const noexcept { return rule_.hammering(); }

 private:
  void crossfade() noexcept;
  double burst_gain() noexcept;
  void blend_statistics() noexcept;

  const SoundSet& sounds_;
  double sample_rate_;
  double crossfade_step_;  ///< share of the crossfade done per chunk
  double burst_chunks_, sustain_gain_, burst_fall_;
  FeedRule rule_;
  BoomState state_;
  std::array<double, kSituationCount> power_{};  ///< power of each situation, sums to 1
  std::array<Slot, kSituationCount> slots_{};
  impact::Statistics statistics_;
  double burst_left_ = 0;  ///< chunks
  double burst_gain_ = 1;
};

}  // namespace rigsound::scene
