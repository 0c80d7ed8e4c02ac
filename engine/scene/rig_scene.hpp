// What the whole rig shall sound like in the next chunk: its diesel and its output level.
#pragma once

#include "background/background_controls.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::scene {

class RigScene {
 public:
  explicit RigScene(const EngineOptions& options) noexcept;

  /// A new state, at a block's start. `hammering`: booms that are. Thread: RT.
  void latch(const MachineState& state, int booms, int hammering) noexcept;

  /// Moves on by one chunk. Thread: RT.
  void advance() noexcept;

  const background::BackgroundControls& background() const noexcept { return background_; }
  double gain_from() const noexcept { return gain_from_; }  ///< output level over the chunk, linear
  double gain_to() const noexcept { return gain_to_; }

 private:
  double overfeed_bar_;
  double load_smoothing_, gain_smoothing_;
  background::BackgroundControls background_;
  double load_ = 0, feed_ = 0;  ///< targets
  double gain_ = 1, gain_from_ = 0, gain_to_ = 0;
};

}  // namespace rigsound::scene
