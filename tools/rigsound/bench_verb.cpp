// rigsound bench: what the engine costs on this machine, layer by layer.
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/block_timer.hpp"
#include "bench/formula_sounds.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

struct Row {
  std::string layer;
  EngineCost cost;
};

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
  no_background.backgrounds.clear();

  const EngineCost whole = measure(options, all, drilling, seconds);
  const EngineCost without_tool = measure(no_tool, all, drilling, seconds);
  const EngineCost without_background = measure(options, no_background, drilling, seconds);
  const EngineCost drill_and_mix = measure(no_tool, no_background, drilling, seconds);
  const EngineCost mix = measure(no_tool, no_background, MachineState{}, seconds);
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

void add_bench(CLI::App& app) {
  struct Options {
    bool json = false;
    double seconds = 10;
  };
  auto* verb = app.add_subcommand("bench", "What the engine costs on this machine, layer by layer");
  auto o = std::make_shared<Options>();
  verb->add_flag("--json", o->json, "figures for programs");
  verb->add_option("--seconds", o->seconds, "sound to play per figure, s")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 3600.0));
  verb->footer(
      "One boom that drills at 1800 r/min, blocks of 64 frames at 48 kHz, sounds made from formulas.\n"
      "Example: rigsound bench --seconds 30");
  verb->callback([o] {
    const std::vector<Row> rows = measure_layers(o->seconds);
    o->json ? print_json(rows) : print_table(rows);
  });
}

}  // namespace rigsound::tools
