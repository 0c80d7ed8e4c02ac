// A rig that any program can play: its engine, and its state set by name.
#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <string_view>

#include "rigsound/engine.hpp"
#include "rigsound/handoff/triple_buffer.hpp"

namespace rigsound::library {

/// What one drill did in the last block.
struct Drilling {
  Situation situation = Situation::kUnderfeed;
  bool hammering = false;
  float impacts_hz = 0;  ///< counted over the last second of sound
};

class PlayingRig {
 public:
  explicit PlayingRig(Engine engine);  ///< Thread: OFF

  const EngineOptions& options() const noexcept { return engine_.options(); }

  /// From the next block on. Errors: std::invalid_argument that names what was expected. Thread: CT.
  void set_signal(std::string_view name, int boom, double value);
  void set_control(std::string_view name, int boom, double value);

  void process(float* out) noexcept;     ///< one block; Thread: RT
  EngineMeters meters() const noexcept;  ///< of the last block; Thread: any

  /// Of the last block; `boom` is one of the rig's. Thread: any.
  Drilling drilling(int boom) const noexcept;

 private:
  struct SharedDrilling {
    std::atomic<Situation> situation{Situation::kUnderfeed};
    std::atomic<bool> hammering{false};
    std::atomic<float> impacts_hz{0};
  };

  void require_boom(int boom) const;

  Engine engine_;
  std::mutex mutex_;    ///< serialises the setters
  MachineState state_;  ///< as the setters left it
  TripleBuffer<MachineState> handoff_;
  std::atomic<float> peak_{0}, rms_{0}, limiter_gain_{1};
  std::atomic<std::uint64_t> lost_clicks_{0};
  std::array<SharedDrilling, kMaxBooms> drilling_;
};

}  // namespace rigsound::library
