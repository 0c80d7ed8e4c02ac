// The engine being started and dying away.
#pragma once

#include <vector>

#include "rigsound/background_model.hpp"

namespace rigsound::background {

/// Gain of the running engine, and the recorded start and stop played over it. Under half the idle speed the
/// engine is not running: its level follows its speed, or, with recordings, makes room for them.
class StartStop {
 public:
  /// One-shots are brought to `sample_rate`. Thread: OFF.
  StartStop(const BackgroundModel& model, double sample_rate, double idle_rpm);

  /// Moves on by kChunk samples at `rpm`, adding a one-shot to `out`. Thread: RT.
  void advance(double rpm, double* out) noexcept;

  double gain_from() const noexcept { return gain_from_; }  ///< 0...1, linear over the chunk
  double gain_to() const noexcept { return gain_to_; }
  bool silent() const noexcept { return gain_to_ == 0 && !shot_.sounds() && !leaving_.sounds(); }

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
  double gain_from_ = 0, gain_to_ = 0;
};

}  // namespace rigsound::background
