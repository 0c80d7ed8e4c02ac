// patch_cost RIG.toml STATES.csv: processor seconds in which Engine::process plays all of it, with nothing
// read or written meanwhile.
#include <time.h>

#include <cstdio>
#include <exception>
#include <vector>

#include "rigsound/audio/block_loop.hpp"
#include "rigsound/config/rig.hpp"
#include "rigsound/session/table_states.hpp"

using namespace rigsound;

namespace {

double processor_s() {
  timespec t{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double played_s(const char* rig_file, const char* states_file) {
  config::Rig rig = config::load_rig(rig_file, config::Buses::kLeftOut);
  session::TableStates states(states_file, rig.engine);
  Engine engine = config::build_engine(rig, config::load_sounds(rig));
  std::vector<float> block = audio::make_block(engine.options());
  const double start_s = processor_s();
  for (std::uint64_t number = 0; const MachineState* const state = states.state_of(number); ++number)
    engine.process(*state, block.data());
  return processor_s() - start_s;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: patch_cost RIG.toml STATES.csv\n"), 2;
  try {
    std::printf("%.6f\n", played_s(argv[1], argv[2]));
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 1;
  }
}
