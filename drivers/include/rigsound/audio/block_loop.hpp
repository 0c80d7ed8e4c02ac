// The one loop that makes sound: state in, a block of the engine, sink. Live and offline differ in the
// StateSource and the Sink they hand in, and in nothing else.
#pragma once

#include <cstdint>
#include <vector>

#include "rigsound/audio/sink.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::audio {

/// What the machine does when a block begins.
class StateSource {
 public:
  virtual ~StateSource() = default;

  /// The state that acts from the first sample of block `number` on, or nullptr when there are no more
  /// blocks. Valid until the next call. Live sources never block, allocate or throw (Thread: RT); sources
  /// that read files throw InputError (Thread: OFF).
  virtual const MachineState* state_of(std::uint64_t number) = 0;

  /// Blocks of silence before block `number`: time that a live run lost, and its engine did not compute.
  virtual std::uint64_t skipped_before(std::uint64_t /*number*/) { return 0; }
};

/// Room for one block of the engine. Thread: OFF.
std::vector<float> make_block(const EngineOptions& options);

/// Renders blocks 0, 1, 2, ... into the sink until the source ends, each through `block`. Returns how many.
/// The engine must be new or reset. Thread: RT or OFF, as the source and the sink are.
std::uint64_t run_blocks(Engine& engine, StateSource& source, Sink& sink, std::vector<float>& block);

}  // namespace rigsound::audio
