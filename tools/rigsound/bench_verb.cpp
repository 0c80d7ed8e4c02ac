// rigsound bench: what the engine costs on this machine, layer by layer.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/block_timer.hpp"
#include "bench/formula_sounds.hpp"
#include "progress_bar.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Row {
  std::string layer;
  EngineCost cost;
};

// Variants are measured in turn, so that a machine that slows down slows all of them.
constexpr int kRounds = 8;

/// Means are those of the quietest round, worst block and deadlines those of all rounds.
void keep_best(EngineCost& best, const EngineCost& round) {
  const EngineCost earlier = best;
  if (earlier.blocks == 0 || round.ns_a_sample < earlier.ns_a_sample) best = round;
  best.worst_block_us = std::max(earlier.worst_block_us, round.worst_block_us);
  best.over_deadline = earlier.over_deadline + round.over_deadline;
  best.blocks = earlier.blocks + round.blocks;
}

EngineCost difference(const EngineCost& with, const EngineCost& without) {
  EngineCost d = with;
  d.ns_a_sample -= without.ns_a_sample;
  d.mean_block_us -= without.mean_block_us;
  if (with.instructions_a_sample && without.instructions_a_sample)
    d.instructions_a_sample = *with.instructions_a_sample - *without.instructions_a_sample;
  return d;
}

/// A layer's cost is what the engine costs with it less what it costs without; a clock inside the render
/// loop would disturb what it measures. Worst block and deadlines are those of the engine with the layer.
std::vector<Row> measure_layers(double seconds) {
  EngineOptions options = full_options();
  options.booms = {{"boom", 0, 0, 0}};
  const SoundSet all = formula_sounds(options.sample_rate);
  MachineState drilling;
  drilling.engine_rpm = 1800;
  drilling.boom[0].feed_pressure_bar = 90;

  EngineOptions no_tool = options;
  no_tool.booms[0].tool = -1;
  SoundSet no_background = all;
  no_background.diesels.clear();

  EngineCost whole, without_tool, without_background, drill_and_mix, mix;
  ProgressBar bar;
  for (int round = 0; round < kRounds; ++round) {
    bar.show(round, kRounds);
    const double share = seconds / kRounds;
    keep_best(whole, measure(options, all, drilling, share));
    keep_best(without_tool, measure(no_tool, all, drilling, share));
    keep_best(without_background, measure(options, no_background, drilling, share));
    keep_best(drill_and_mix, measure(no_tool, no_background, drilling, share));
    keep_best(mix, measure(no_tool, no_background, MachineState{}, share));
  }
  return {{"drill", difference(drill_and_mix, mix)},
          {"tool", difference(whole, without_tool)},
          {"background", difference(whole, without_background)},
          {"scene+mix", mix},
          {"engine", whole}};
}

void print_table(const std::vector<Row>& rows) {
  fmt::print("{:<12}{:>14}{:>16}{:>16}{:>16}{:>16}\n", "layer", "ns/sample", "instr/sample", "mean block us",
             "worst block us", "over deadline");
  for (const Row& row : rows) {
    const EngineCost& c = row.cost;
    const std::string instructions =
        c.instructions_a_sample ? fmt::format("{:.0f}", *c.instructions_a_sample) : "n/a";
    fmt::print("{:<12}{:>14.1f}{:>16}{:>16.2f}{:>16.2f}{:>10} of {}\n", row.layer, c.ns_a_sample,
               instructions, c.mean_block_us, c.worst_block_us, c.over_deadline, c.blocks);
  }
}

void print_json(const std::vector<Row>& rows) {
  nlohmann::ordered_json layers;
  for (const Row& row : rows) {
    const EngineCost& c = row.cost;
    nlohmann::ordered_json& entry = layers[row.layer];
    entry["ns_a_sample"] = c.ns_a_sample;
    entry["instructions_a_sample"] =
        c.instructions_a_sample ? nlohmann::json(*c.instructions_a_sample) : nlohmann::json();
    entry["mean_block_us"] = c.mean_block_us;
    entry["worst_block_us"] = c.worst_block_us;
    entry["blocks"] = c.blocks;
    entry["over_deadline"] = c.over_deadline;
  }
  fmt::print("{}\n", layers.dump(2));
}

}  // namespace

void add_bench(cli::Verb& program) {
  struct Options {
    bool json = false;
    double seconds = 10;
  };
  cli::Verb verb = program.verb("bench", "Measure what the synthesiser costs on this machine, layer by layer")
                       .group(kInspect);
  auto o = std::make_shared<Options>();
  verb.flag("--json", o->json, "figures for programs");
  verb.option("--seconds", o->seconds, "sound to play per figure").range(0.1, 3600, "s").shows_default();
  verb.details(
      "One boom that drills at 1800 r/min, blocks of 64 frames at 48 kHz, sounds made from formulas.\n"
      "Means are those of the quietest of eight rounds, worst blocks those of all.");
  verb.example("rigsound bench --seconds 30");
  verb.callback([o] {
    const std::vector<Row> rows = measure_layers(o->seconds);
    o->json ? print_json(rows) : print_table(rows);
  });
}

}  // namespace rigsound::tools
