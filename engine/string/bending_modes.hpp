// Bending of the rod outside the hole: a bank of modes that follow its exposed length.
#pragma once

#include "rigsound/string_model.hpp"
#include "string/design/mode_table.hpp"
#include "string/string_kernel.hpp"

namespace rigsound::string {

class BendingModes {
 public:
  /// Silent, the whole rod exposed and free. Thread: OFF.
  BendingModes(const StringModel& model, double sample_rate, dsp::LaneWidth width);

  /// Takes effect within four chunks, a quarter of the modes each, the highest at once. `contact` 0...1
  /// damps. Thread: RT.
  void set(double exposed_m, double contact) noexcept;

  /// Silence, and at once what set() asked for. Thread: RT.
  void retune() noexcept;

  /// kChunk samples, as loud as the model mixes them. x: strikes, zero but where `struck`. Thread: RT.
  void process(const double* x, bool struck, double* out) noexcept;

  /// Never grows without input, whatever is set.
  double energy() const noexcept;
  void silence() noexcept;

  /// What mode 1...kMaxModes is tuned to. Thread: OFF.
  double frequency_hz(int mode) const noexcept;
  double t60_s(int mode) const noexcept;

 private:
  /// 1 - r of a mode at t = tan(pi f / rate): loss + slope t^2.
  struct Damping {
    double loss, slope;
  };
  Damping damping_of(double low_s, double high_s) const noexcept;
  void choose_groups() noexcept;
  void tune_some() noexcept;
  void forget_silent(int group) noexcept;

  StringKernel kernel_;
  ModeTable table_;
  double sample_rate_;
  Damping free_, pressed_;
  double shortest_m_, gain_, fade_to_;
  double exposed_m_ = 0, contact_ = 0;
  ModesTuning tuning_;
  ModesState state_{};
  int turn_ = 0;          ///< which quarter of the groups comes next
  int stale_ = 0;         ///< quarters that still play what was set before
  unsigned visited_ = 0;  ///< chunks
};

}  // namespace rigsound::string
