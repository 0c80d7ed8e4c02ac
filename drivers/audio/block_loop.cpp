#include "rigsound/audio/block_loop.hpp"

#include <vector>

namespace rigsound::audio {

std::uint64_t run_blocks(Engine& engine, StateSource& source, Sink& sink) {
  const EngineOptions& options = engine.options();
  std::vector<float> block(static_cast<std::size_t>(options.block) *
                           static_cast<std::size_t>(options.channels));
  std::uint64_t number = 0;
  while (const MachineState* state = source.state_of(number)) {
    engine.process(*state, block.data());
    sink.write(block.data(), number++);
  }
  return number;
}

}  // namespace rigsound::audio
