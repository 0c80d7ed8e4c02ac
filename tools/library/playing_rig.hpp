// A rig that any program can play: its engine, and its state set by name.
#pragma once

#include <atomic>
#include <mutex>
#include <string_view>

#include "rigsound/engine.hpp"
#include "rigsound/handoff/triple_buffer.hpp"

namespace rigsound::library {

class PlayingRig {
 public:
  explicit PlayingRig(Engine engine);  ///< Thread: OFF

  const EngineOptions& options() const noexcept { return engine_.options(); }

  /// From the next block on. Errors: std::invalid_argument that names what was expected. Thread: CT.
  void set_signal(std::string_view name, int boom, double value);
  void set_control(std::string_view name, int boom, double value);

  void process(float* out) noexcept;     ///< one block; Thread: RT
  EngineMeters meters() const noexcept;  ///< of the last block; Thread: any

 private:
  void require_boom(int boom) const;

  Engine engine_;
  std::mutex mutex_;    ///< serialises the setters
  MachineState state_;  ///< as the setters left it
  TripleBuffer<MachineState> handoff_;
  std::atomic<float> peak_{0}, rms_{0}, limiter_gain_{1};
  std::atomic<std::uint64_t> lost_clicks_{0};
};

}  // namespace rigsound::library
