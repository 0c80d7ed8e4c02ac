// What one boom shall sound like in the next chunk.
#pragma once

#include <array>

#include "drill/drill_input.hpp"
#include "impact/impact_train.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/options.hpp"
#include "rigsound/sound_set.hpp"
#include "scene/feed_rule.hpp"
#include "tool/tool_input.hpp"

namespace rigsound::scene {

class BoomScene {
 public:
  BoomScene(const EngineOptions& options, const SoundSet& sounds) noexcept;

  /// A new state, at a block's start. Thread: RT.
  void latch(const BoomState& state) noexcept;

  /// Moves on by one chunk. Thread: RT.
  void advance() noexcept;

  const impact::Statistics& impacts() const noexcept { return statistics_; }
  const drill::DrillInput& drill() const noexcept { return drill_; }
  const tool::ToolInput& tool() const noexcept { return tool_; }
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
  drill::DrillInput drill_;
  tool::ToolInput tool_;
  impact::Statistics statistics_;
  double burst_left_ = 0;  ///< chunks
  double burst_gain_ = 1;
};

}  // namespace rigsound::scene
