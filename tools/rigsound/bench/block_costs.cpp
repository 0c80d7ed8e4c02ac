#include "bench/block_costs.hpp"

#include <time.h>

#include <algorithm>
#include <numeric>

#include "bench/instruction_counter.hpp"
#include "rigsound/monotonic_time.hpp"

namespace rigsound::tools {
namespace {

double thread_us() {
  timespec t{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e6 + static_cast<double>(t.tv_nsec) * 1e-3;
}

/// What asking for the time costs, which lies in every time measured.
double clock_us() {
  double least = 1e9;
  for (int i = 0; i < 1000; ++i) {
    const double start = thread_us();
    least = std::min(least, thread_us() - start);
  }
  return least;
}

}  // namespace

void add_run(BlockCosts& costs, Engine engine, audio::StateSource& states, std::uint64_t settling) {
  std::vector<float> block = audio::make_block(engine.options());
  std::vector<double> run_us;
  run_us.reserve(costs.least_us.size());
  const double asking_us = clock_us(), wall_start_s = monotonic_s(), processor_start_us = thread_us();
  std::uint64_t counted = 0;
  const InstructionCounter instructions;
  for (std::uint64_t number = 0; const MachineState* const state = states.state_of(number); ++number) {
    const std::uint64_t before = instructions.read().value_or(0);
    const double start = thread_us();
    engine.process(*state, block.data());
    const double us = std::max(0.0, thread_us() - start - asking_us);
    if (number < settling) continue;
    run_us.push_back(us);
    counted += instructions.read().value_or(0) - before;
  }
  costs.processor_s += (thread_us() - processor_start_us) * 1e-6;
  costs.wall_s += monotonic_s() - wall_start_s;
  if (run_us.empty()) return;
  const auto blocks = static_cast<double>(run_us.size());
  costs.mean_us.push_back(std::accumulate(run_us.begin(), run_us.end(), 0.0) / blocks);
  if (counted > 0) {
    const double mean = static_cast<double>(counted) / blocks;
    costs.instructions_a_block = std::min(costs.instructions_a_block.value_or(mean), mean);
  }
  if (costs.least_us.empty()) costs.least_us = run_us;
  for (std::size_t i = 0; i < costs.least_us.size(); ++i)
    costs.least_us[i] = std::min(costs.least_us[i], run_us[i]);
}

}  // namespace rigsound::tools
