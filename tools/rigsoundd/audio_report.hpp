// What the audio thread tells of the sound it makes, once a block.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "rigsound/engine.hpp"
#include "rigsound/sound_level_meter.hpp"

namespace rigsound::daemon {

/// Peak and energy of one signal over some blocks. Plain data.
struct LevelSum {
  float peak = 0;
  double energy = 0;  ///< mean squares of the blocks, added up

  void add(LayerLevel block) noexcept {
    peak = std::max(peak, block.peak);
    energy += static_cast<double>(block.rms) * static_cast<double>(block.rms);
  }
  void add(const LevelSum& other) noexcept {
    peak = std::max(peak, other.peak);
    energy += other.energy;
  }
  double rms(std::uint64_t blocks) const {
    return blocks > 0 ? std::sqrt(energy / static_cast<double>(blocks)) : 0;
  }
};

/// How loud some blocks were for an ear. Plain data.
struct SoundSum {
  double power = 0;           ///< means of the blocks, added up
  double c_peak = 0;          ///< highest
  double fast = 0, slow = 0;  ///< at the end

  void add(const SoundLevel& block) noexcept {
    power += block.mean;
    c_peak = std::max(c_peak, block.c_peak);
    fast = block.fast, slow = block.slow;
  }
};

/// Levels of the output and of every layer over some blocks. Plain data.
struct LevelWindow {
  std::uint32_t number = 0;  ///< counts the windows of an audio thread from 1; 0: none
  std::uint64_t blocks = 0;
  LevelSum output, diesel;
  std::array<LevelSum, kMaxBooms> drill{}, tool{};
  float limiter_gain = 1;  ///< lowest, linear
  SoundSum sound;          ///< of this window alone; sums of windows leave it out

  void add(const EngineMeters& meters, const EngineView& view) noexcept {
    ++blocks;
    output.add(LayerLevel{meters.peak, meters.rms});
    diesel.add(view.diesel);
    for (std::size_t b = 0; b < kMaxBooms; ++b)
      drill[b].add(view.boom[b].drill), tool[b].add(view.boom[b].tool);
    limiter_gain = std::min(limiter_gain, meters.limiter_gain);
  }
  void add(const LevelWindow& other) noexcept {
    blocks += other.blocks;
    output.add(other.output);
    diesel.add(other.diesel);
    for (std::size_t b = 0; b < kMaxBooms; ++b) drill[b].add(other.drill[b]), tool[b].add(other.tool[b]);
    limiter_gain = std::min(limiter_gain, other.limiter_gain);
  }
};

/// Plain data.
struct AudioReport {
  EngineView view;     ///< of the last block
  LevelWindow closed;  ///< the last window that is complete
};

}  // namespace rigsound::daemon
