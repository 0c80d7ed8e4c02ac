// The real-time engine: machine state in, one fixed block of samples out.
#pragma once

#include <cstdint>
#include <memory>

#include "rigsound/engine_view.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/options.hpp"
#include "rigsound/sound_set.hpp"

namespace rigsound {

/// What the last block was like. Thread: RT (the thread that calls process).
struct EngineMeters {
  float peak = 0;  ///< of the last block, linear, after the limiter
  float rms = 0;
  float limiter_gain = 1;         ///< lowest of the last block, linear
  std::uint64_t lost_clicks = 0;  ///< clicks dropped because every voice was busy, since construction
  /// Chunks of kChunk frames that one layer was left out of because it had made something that is no number;
  /// since construction. It begins again from silence.
  std::uint64_t dropped_chunks = 0;
};

class Engine {
 public:
  /// Builds every table and voice. Throws std::invalid_argument when an option is out of range or the
  /// sound set has no bank for a situation. Thread: OFF.
  Engine(const EngineOptions& options, SoundSet sounds);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  /// One block. `out`: block x channels samples, interleaved; neither they nor what a true-peak meter (ITU-R
  /// BS.1770-4) finds between them exceeds the ceiling. `state` acts from the first sample on, which is heard
  /// lookahead_frames() later. Never allocates, locks, throws or calls libm. Thread: RT.
  void process(const MachineState& state, float* out) noexcept;

  EngineMeters meters() const noexcept;     ///< Thread: RT
  const EngineView& view() const noexcept;  ///< of the last block; valid until the next. Thread: RT
  const EngineOptions& options() const noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigsound
