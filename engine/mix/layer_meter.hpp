// The way of a layer into the mix: its level is taken, and what is no sound is kept out.
#pragma once

#include <cstdint>
#include <utility>

#include "mix/buses.hpp"
#include "mix/level_meter.hpp"

namespace rigsound::mix {

/// One for each layer. Thread: RT.
class LayerMeter {
 public:
  /// A chunk that `layer` has put on `bus`. One that is no sound is dropped and counted, and the layer begins
  /// again from silence.
  template <class Layer>
  void admit(Layer& layer, Bus& bus) noexcept {
    if (!bus.sounds || level_.add(bus.x, kChunk)) return;
    bus.sounds = false;
    layer.reset();
    ++dropped_;
  }

  /// Of a block of `frames`, at `gain`; begins anew.
  LayerLevel take(double gain, int frames) noexcept { return level_.take(gain, frames); }
  std::uint64_t take_dropped() noexcept {
    return std::exchange(dropped_, 0);
  }  ///< chunks since the last call

 private:
  LevelMeter level_;
  std::uint64_t dropped_ = 0;
};

}  // namespace rigsound::mix
