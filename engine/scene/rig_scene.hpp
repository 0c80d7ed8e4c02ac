// What the whole rig shall sound like in the next chunk: its diesel and its output level.
#pragma once

#include "rigsound/diesel_player.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/rpm_tracker.hpp"
#include "rigsound/options.hpp"

namespace rigsound::scene {

class RigScene {
 public:
  explicit RigScene(const EngineOptions& options) noexcept;

  /// A new state, at a block's start. `hammering`: booms that are. Thread: RT.
  void set(const MachineState& state, int booms, int hammering) noexcept;

  /// Moves on by one chunk. Thread: RT.
  void advance() noexcept;

  /// The simulator is paused or back at its start, and the sound has faded. Thread: RT.
  bool stands_still() const noexcept { return paused_ && gain_.rests_at(0); }

  const DieselInput& diesel() const noexcept { return diesel_; }
  const dsp::Ramp& gain() const noexcept { return gain_; }  ///< output level over the chunk, linear

 private:
  double chunk_s_, overfeed_bar_;
  double load_smoothing_, gain_smoothing_;
  DieselInput diesel_;
  SpeedTrend speed_;  ///< as the last state that changed it said
  double speed_age_s_ = 0;
  double load_ = 0, feed_ = 0, wanted_gain_ = 1;  ///< targets
  dsp::Ramp gain_;
  bool paused_ = false;
};

}  // namespace rigsound::scene
