// What one boom shall sound like in the next chunk.
#pragma once

#include <array>

#include "drill/drill_input.hpp"
#include "impact/impact_train.hpp"
#include "rigsound/engine_view.hpp"
#include "rigsound/feed_rule.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/options.hpp"
#include "rigsound/sound_set.hpp"
#include "scene/feed_axis.hpp"
#include "string/string_input.hpp"
#include "tool/tool_input.hpp"

namespace rigsound::scene {

class BoomScene {
 public:
  /// `spectra`: of a sound set that must outlive it. Thread: OFF.
  BoomScene(const EngineOptions& options, const ClickSpectra& spectra, int index);

  /// A new state, at a block's start. Thread: RT.
  void set(const BoomState& state) noexcept;

  /// Moves on by one chunk. Thread: RT.
  void advance() noexcept;

  const impact::Statistics& impacts() const noexcept { return statistics_; }
  const drill::DrillInput& drill() const noexcept { return drill_; }
  const tool::ToolInput& tool() const noexcept { return tool_; }
  const string::StringInput& rods() const noexcept { return string_; }
  bool hammering() const noexcept { return rule_.hammering(); }

  /// Fills in what the scene has decided: all but what was made of it. Thread: RT.
  void describe(BoomView& view) const noexcept;

 private:
  void crossfade() noexcept;
  double burst_gain() noexcept;
  void follow_feed() noexcept;
  void place_drilling() noexcept;
  void set_string(const BoomState& state) noexcept;
  void place_rattling(drill::Voicing voicing, Situation situation) noexcept;
  void blend_statistics() noexcept;
  impact::Statistics drilling_statistics() const noexcept;

  const SoundSet* sounds_;
  double sample_rate_;
  FeedPoints points_;
  FeedAxis axis_;
  double crossfade_step_;                   ///< share of the crossfade done per chunk
  double feed_remainder_, rods_remainder_;  ///< of the way to the target that is left after a chunk
  double burst_chunks_, sustain_gain_, burst_fall_;
  FeedRule rule_;
  double contact_bar_, rod_length_m_;
  BoomState state_;
  double feed_ = 0, rods_ = 1;  ///< smoothed
  bool moved_ = true;           ///< the place on the axis has to be found anew
  FeedPlace place_;
  std::array<const BankUse*, drill::kVoicings> rattling_{};  ///< what rattles; null: nothing, or it drills
  std::array<double, drill::kVoicings> power_{};             ///< sums to 1
  drill::DrillInput drill_;
  tool::ToolInput tool_;
  string::StringInput string_;
  impact::Statistics statistics_;
  bool snap_ = false;      ///< a rod breaks in the next chunk
  double burst_left_ = 0;  ///< chunks
  double burst_gain_ = 1;
};

}  // namespace rigsound::scene
