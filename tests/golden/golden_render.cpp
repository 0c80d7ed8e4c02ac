// Renders the drilled hole for a minute and writes its bits to stdout. Depends on the engine alone, so
// that any compiler can build it from source in one line.
#include <cstdio>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

int main() {
  const EngineOptions options = tools::full_options();
  Engine engine(options, tools::formula_sounds(options.sample_rate));
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  for (int frame = 0; frame < 60 * 48000; frame += options.block) {
    engine.process(tools::drilled_hole(frame / options.sample_rate), block.data());
    if (std::fwrite(block.data(), sizeof(float), block.size(), stdout) != block.size()) return 3;
  }
  return 0;
}
