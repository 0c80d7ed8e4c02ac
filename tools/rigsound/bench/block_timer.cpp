#include "bench/block_timer.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/instruction_counter.hpp"

namespace rigsound::tools {

EngineCost measure(const EngineOptions& options, const SoundSet& sounds, const MachineState& state,
                   double seconds) {
  using Clock = std::chrono::steady_clock;
  Engine engine(options, sounds);
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  const double block_s = options.block / options.sample_rate;
  for (double warm_up = 0; warm_up < 1; warm_up += block_s) engine.process(state, block.data());

  EngineCost cost;
  cost.blocks = std::max(1L, static_cast<long>(seconds / block_s));
  const InstructionCounter instructions;
  double total_us = 0;
  for (long b = 0; b < cost.blocks; ++b) {
    const auto start = Clock::now();
    engine.process(state, block.data());
    const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    total_us += us;
    cost.worst_block_us = std::max(cost.worst_block_us, us);
    cost.over_deadline += us > block_s * 1e6 ? 1 : 0;
  }
  const double samples = static_cast<double>(cost.blocks) * options.block;
  cost.mean_block_us = total_us / static_cast<double>(cost.blocks);
  cost.ns_a_sample = total_us * 1e3 / samples;
  if (const auto count = instructions.read())
    cost.instructions_a_sample = static_cast<double>(*count) / samples;
  return cost;
}

}  // namespace rigsound::tools
