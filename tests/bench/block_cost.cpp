// block_cost silent|busy BLOCKS: plays so many blocks of 64 frames, stereo, after the first half second: for
// callgrind, which counts the instructions of Engine::process. One boom with bar, equaliser and diesel;
// silent: all of it at rest.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

namespace {

constexpr int kSettling = 400;  // blocks

/// Not inlined: callgrind counts while it is inside.
[[gnu::noinline]] void counted_blocks(Engine& engine, const MachineState& state, float* out, int blocks) {
  for (int i = 0; i < blocks; ++i) engine.process(state, out);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: block_cost silent|busy BLOCKS\n"), 2;
  EngineOptions options = tools::full_options();
  options.booms = {{"boom", 0, 0, 0}};
  MachineState state;
  if (std::strcmp(argv[1], "busy") == 0) state.engine_rpm = 1800, state.boom[0].feed_pressure_bar = 90;
  Engine engine(options, tools::formula_sounds(options.sample_rate));
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  for (int i = 0; i < kSettling; ++i) engine.process(state, block.data());
  counted_blocks(engine, state, block.data(), std::atoi(argv[2]));
}
