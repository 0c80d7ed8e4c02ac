// A recorded bus as a source of states, block by block.
#pragma once

#include "rigsound/audio/block_loop.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/machine/state_resolver.hpp"

namespace rigsound::session {

/// A frame acts from the first block on that begins at its time or later. Ends with the last frame.
/// Thread: OFF.
class LogStates : public audio::StateSource {
 public:
  LogStates(log::BusLog& log, const SafetyOptions& safety, const EngineOptions& options)
      : log_(log), safety_(safety), block_s_(options.block / options.sample_rate) {}

  const MachineState* state_of(std::uint64_t number) override {
    if (!log_.next_s()) return nullptr;
    const double now_s = static_cast<double>(number) * block_s_;
    const bool changed = log_.read_until(now_s, board_);
    if (changed || resolver_.due(now_s)) state_ = resolver_.resolve(board_, safety_, now_s);
    return &state_;
  }

  const SignalBoard& board() const { return board_; }  ///< what is known of the signals so far

 private:
  log::BusLog& log_;
  SafetyOptions safety_;
  SignalBoard board_;
  StateResolver resolver_;
  double block_s_;
  MachineState state_;
};

}  // namespace rigsound::session
