// block_cost silent|busy|busiest|shift: plays blocks of 64 frames, stereo, for callgrind, which counts the
// instructions of each call of counted_block. One boom with bar, equaliser and diesel. silent: all of it at
// rest; busy: it drills; busiest: as fast as it can; shift: all that a rig can do
// one after the other.
#include <cstdio>
#include <cstring>
#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::bench {

/// Not inlined: callgrind counts while it is inside.
[[gnu::noinline]] void counted_block(Engine& engine, const MachineState& state, float* out);

void counted_block(Engine& engine, const MachineState& state, float* out) { engine.process(state, out); }

}  // namespace rigsound::bench

using namespace rigsound;

namespace {

constexpr int kSettling = 400, kSteady = 200;  // blocks

/// What the rig does for some blocks.
struct Step {
  int blocks;
  float rpm, feed_bar;
  Rattling rattling = Rattling::kNone;
  float rate_hz = 0;
  int rods = 1;
  Simulation simulation = Simulation::kRun;
};

constexpr Step kShift[] = {
    {100, 0, 0},
    {900, 800, 0},  // the diesel starts
    {150, 1800, 0},
    {150, 1800, 40},
    {150, 1800, 90},
    {150, 1800, 150},
    {150, 1800, 90, Rattling::kNone, 110},
    {150, 1800, 90, Rattling::kNone, 0, 3},
    {150, 1800, 0, Rattling::kClosed},
    {150, 1800, 0, Rattling::kOpen},
    {150, 2200, 150},
    {150, 2200, 150, Rattling::kNone, 0, 1, Simulation::kFreeze},
    {100, 2200, 150},
    {150, 2200, 150, Rattling::kNone, 0, 1, Simulation::kReset},
    {150, 2200, 150},
    {150, 0, 0},  // and stops
};

MachineState state_of(const Step& step) {
  MachineState state;
  state.engine_rpm = step.rpm;
  state.simulation = step.simulation;
  BoomState& boom = state.boom[0];
  boom.feed_pressure_bar = step.feed_bar;
  boom.rattling = step.rattling;
  boom.percussion_rate_hz = step.rate_hz;
  boom.rod_count = static_cast<decltype(boom.rod_count)>(step.rods);
  return state;
}

class Player {
 public:
  Player() : engine_(options(), tools::formula_sounds(options().sample_rate)) {}

  void settle(const MachineState& state) {
    for (int i = 0; i < kSettling; ++i) engine_.process(state, block_.data());
  }
  void count(const MachineState& state, int blocks) {
    for (int i = 0; i < blocks; ++i) bench::counted_block(engine_, state, block_.data());
  }

 private:
  static EngineOptions options() {
    EngineOptions options = tools::full_options();
    options.booms = {{"boom", 0, 0, 0}};
    return options;
  }

  Engine engine_;
  std::vector<float> block_ =
      std::vector<float>(static_cast<std::size_t>(options().block * options().channels));
};

bool play(Player& player, const char* what) {
  const Step busy{kSteady, 1800, 90}, busiest{kSteady, 2200, 150, Rattling::kNone, 120};
  if (std::strcmp(what, "shift") == 0) {
    for (const Step& step : kShift) player.count(state_of(step), step.blocks);
    return true;
  }
  MachineState state;
  if (std::strcmp(what, "busy") == 0)
    state = state_of(busy);
  else if (std::strcmp(what, "busiest") == 0)
    state = state_of(busiest);
  else if (std::strcmp(what, "silent") != 0)
    return false;
  player.settle(state);
  player.count(state, kSteady);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  Player player;
  if (argc == 2 && play(player, argv[1])) return 0;
  return std::fprintf(stderr, "usage: block_cost silent|busy|busiest|shift\n"), 2;
}
