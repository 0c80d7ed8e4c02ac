#include "bench/layer_costs.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "bench/steady_states.hpp"

namespace rigsound::tools {
namespace {

constexpr int kRounds = 6;
constexpr double kQuietShare = 0.9, kQuietDifference = 0.05;

config::SoundingRig without_tools(config::SoundingRig rig) {
  for (BoomOptions& boom : rig.engine.booms) boom.tool = -1;
  return rig;
}

SoundSet without_diesel(SoundSet sounds) {
  sounds.diesels.clear();
  return sounds;
}

LayerCost cost_of(std::string name, std::vector<double> us, std::optional<double> instructions,
                  double block_us) {
  LayerCost cost;
  cost.name = std::move(name);
  cost.instructions_a_block = instructions;
  cost.blocks = static_cast<long>(us.size());
  if (us.empty()) return cost;
  cost.mean_us = std::accumulate(us.begin(), us.end(), 0.0) / static_cast<double>(us.size());
  cost.over_deadline = std::count_if(us.begin(), us.end(), [&](double t) { return t > block_us; });
  std::sort(us.begin(), us.end());
  const auto below = [&](double part) {
    return us[static_cast<std::size_t>(part * static_cast<double>(us.size() - 1))];
  };
  cost.p50_us = below(0.5), cost.p99_us = below(0.99), cost.p999_us = below(0.999), cost.worst_us = us.back();
  return cost;
}

LayerCost difference(std::string name, const BlockCosts& with, const BlockCosts& without, double block_us) {
  std::vector<double> us = with.least_us;
  for (std::size_t i = 0; i < us.size(); ++i) us[i] -= without.least_us[i];
  std::optional<double> instructions;
  if (with.instructions_a_block && without.instructions_a_block)
    instructions = *with.instructions_a_block - *without.instructions_a_block;
  return cost_of(std::move(name), std::move(us), instructions, block_us);
}

double second_over_best(std::vector<double> means) {
  std::sort(means.begin(), means.end());
  return means.size() > 1 && means[0] > 0 ? means[1] / means[0] - 1 : 0;
}

}  // namespace

bool BenchResult::quiet() const { return had >= kQuietShare && differ <= kQuietDifference; }

// The variants take turns, so that a machine that slows down slows all of them.
BenchResult layer_costs(const Workload& work, const std::function<void(double)>& shown) {
  const config::SoundingRig no_tool = without_tools(work.rig);
  const SoundSet no_diesel = without_diesel(work.sounds);
  BlockCosts whole, tool_missing, diesel_missing, drill_and_mix, mix;
  int done = 0;
  const auto run = [&](BlockCosts& costs, const config::SoundingRig& rig, const SoundSet& sounds,
                       audio::StateSource& states) {
    add_run(costs, config::build_engine(rig, sounds), states, work.settling);
    shown(++done / (5.0 * kRounds));
  };
  for (int round = 0; round < kRounds; ++round) {
    run(whole, work.rig, work.sounds, *work.states());
    run(tool_missing, no_tool, work.sounds, *work.states());
    run(diesel_missing, work.rig, no_diesel, *work.states());
    run(drill_and_mix, no_tool, no_diesel, *work.states());
    SteadyStates rest({}, whole.least_us.size() + work.settling);
    run(mix, no_tool, no_diesel, rest);
  }

  BenchResult result;
  result.frames = work.rig.engine.block;
  result.block_us = 1e6 * work.rig.engine.block / work.rig.engine.sample_rate;
  const double block_us = result.block_us;
  result.layers = {difference("drill", drill_and_mix, mix, block_us),
                   difference("tool", whole, tool_missing, block_us),
                   difference("background", whole, diesel_missing, block_us),
                   cost_of("scene+mix", mix.least_us, mix.instructions_a_block, block_us),
                   cost_of("engine", whole.least_us, whole.instructions_a_block, block_us)};
  double processor_s = 0, wall_s = 0;
  for (const BlockCosts* costs : {&whole, &tool_missing, &diesel_missing, &drill_and_mix, &mix})
    processor_s += costs->processor_s, wall_s += costs->wall_s;
  result.had = wall_s > 0 ? processor_s / wall_s : 0;
  result.differ = second_over_best(whole.mean_us);
  return result;
}

}  // namespace rigsound::tools
