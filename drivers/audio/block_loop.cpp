#include "rigsound/audio/block_loop.hpp"

namespace rigsound::audio {

std::vector<float> make_block(const EngineOptions& options) {
  return std::vector<float>(options.block * options.channels);
}

std::uint64_t run_blocks(Engine& engine, StateSource& source, Sink& sink, std::vector<float>& block) {
  std::uint64_t number = 0;
  while (const MachineState* state = source.state_of(number)) {
    if (const std::uint64_t skipped = source.skipped_before(number); skipped > 0) sink.skip(skipped);
    engine.process(*state, block.data());
    sink.write(block.data(), number++);
  }
  return number;
}

}  // namespace rigsound::audio
