// Where readings of all buses, live controls and output fades meet, on their way to the audio thread.
#pragma once

#include <array>
#include <functional>
#include <mutex>

#include "output_fade.hpp"
#include "rigsound/handoff/triple_buffer.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::daemon {

/// All that the state of a block follows from. Plain data.
struct StateInput {
  SignalBoard board;
  SafetyOptions safety;
  std::array<DrillControls, kMaxBooms> controls{};
  OutputFade mute, gate, exposure;
  std::uint64_t revision = 0;  ///< counts changes
};

/// Bus threads and the control socket change it under a lock; each change is at once in the handoff, so the
/// next block hears it.
class StateExchange {
 public:
  explicit StateExchange(const SafetyOptions& safety);

  void change(const std::function<void(SignalBoard&)>& edit);  ///< Thread: CT

  void set_control(int boom, const ControlInfo& control, double value);  ///< Thread: CT
  DrillControls controls(int boom) const;                                ///< Thread: CT

  void set_muted(bool muted, double fade_s);  ///< Thread: CT
  bool muted() const;                         ///< Thread: CT
  /// Second output gain, for engine swap and shutdown fades: 0 silent, 1 open. Thread: CT
  void set_gate(double target, double fade_s);

  /// Third output gain, for the limit of exposure. Thread: CT
  void set_exposure_gain(double gain, double fade_s);

  void set_safety(const SafetyOptions& safety);  ///< Thread: CT

  /// What is known of the signals now. Thread: CT
  SignalBoard board() const;
  SafetyOptions safety() const;

  TripleBuffer<StateInput>& handoff() { return handoff_; }  ///< its reader: the audio thread, RT

 private:
  template <typename Edit>
  void edit(Edit edit);

  mutable std::mutex mutex_;
  StateInput input_;
  bool muted_ = false;
  TripleBuffer<StateInput> handoff_;
};

}  // namespace rigsound::daemon
