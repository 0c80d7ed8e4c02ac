// The engine being started and dying away.
#pragma once

#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/dsp/ramp.hpp"

namespace rigsound::diesel {

/// Gain of the running engine, and the recorded start and stop played over it. Under half the idle speed the
/// engine is not running: its level follows its speed, or, with recordings, makes room for them.
class StartStop {
 public:
  /// One-shots are brought to `sample_rate`. Thread: OFF.
  StartStop(const DieselModel& model, double sample_rate, double idle_rpm);

  /// Moves on by kChunk samples at `rpm`. Thread: RT.
  void advance(double rpm) noexcept;
  /// Adds their one-shots to `out`. Thread: RT.
  void add_to(double* out) noexcept;

  const dsp::Ramp& gain() const noexcept { return gain_; }  ///< 0...1, linear over the chunk
  bool silent() const noexcept { return gain_.rests_at(0) && !shot_.sounds() && !leaving_.sounds(); }

 private:
  enum class Phase { kOff, kStarting, kRunning, kStopping };

  struct Shot {
    const std::vector<float>* samples = nullptr;
    std::size_t at = 0;
    double gain = 1;
    bool broken_off = false;

    bool sounds() const noexcept { return samples != nullptr; }
    std::size_t left() const noexcept { return samples ? samples->size() - at : 0; }
    void add(double fade, double* out) noexcept;
  };

  void play(const std::vector<float>& samples, Phase phase) noexcept;
  void break_off() noexcept;
  void follow(double rpm) noexcept;
  double target(double rpm) const noexcept;

  std::vector<float> start_, stop_;
  double running_rpm_, smoothing_, fade_, handover_;
  Phase phase_ = Phase::kOff;
  Shot shot_, leaving_;
  dsp::Ramp gain_;
};

}  // namespace rigsound::diesel
