// Where readings of all buses become the one state that the audio thread takes.
#pragma once

#include <array>
#include <functional>
#include <mutex>

#include "output_fade.hpp"
#include "rigsound/handoff/triple_buffer.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::daemon {

/// Bus threads and the control socket change it under a lock; each change is at once in the handoff, so the
/// next block hears it. tick() must be called every few milliseconds for fades and ageing.
class StateExchange {
 public:
  explicit StateExchange(const SafetyOptions& safety);

  void change(const std::function<void(SignalBoard&)>& edit);  ///< Thread: CT
  void tick();                                                 ///< Thread: CT

  void set_controls(int boom, const DrillControls& controls);  ///< Thread: CT
  DrillControls controls(int boom) const;                      ///< Thread: CT

  void set_muted(bool muted, double fade_s);  ///< Thread: CT
  bool muted() const;                         ///< Thread: CT
  /// A second hand on the volume, for changes of engine and the end: 0 silent, 1 open. Thread: CT
  void set_gate(double target, double fade_s);

  /// New safety rules; what is known of the signals stays. Thread: CT
  void set_safety(const SafetyOptions& safety);

  SignalBoard::Reading reading(SignalId id) const;  ///< Thread: CT
  double resolved(SignalId id) const;               ///< Thread: CT
  float output_gain() const;  ///< safety, mute and gate together, as last told the engine. Thread: CT

  TripleBuffer<MachineState>& handoff() { return handoff_; }  ///< its reader: the audio thread, RT

 private:
  void publish();

  mutable std::mutex mutex_;
  SignalBoard board_;
  std::array<DrillControls, kMaxBooms> controls_{};
  OutputFade mute_{1}, gate_{1};
  bool muted_ = false;
  float output_gain_ = 1;
  TripleBuffer<MachineState> handoff_;
};

}  // namespace rigsound::daemon
