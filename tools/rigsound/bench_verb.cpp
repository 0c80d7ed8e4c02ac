// rigsound bench: whether a rig fits this machine, and what each layer costs.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>

#include "bench/layer_costs.hpp"
#include "bench/workload.hpp"
#include "figure_row.hpp"
#include "progress_bar.hpp"
#include "verbs.hpp"

namespace rigsound::tools {
namespace {

constexpr double kSteady_s = 6;       // of sound a run where nobody says
constexpr double kComfortable = 0.5;  // of a block: the rest is for the card, the kernel and other programs

struct BenchArguments {
  std::string rig;
  LogArguments log;
  double seconds = 0;  ///< 0: left out
  bool json = false;
};

BenchResult measured(const BenchArguments& options) {
  const double seconds = options.seconds > 0 ? options.seconds : kSteady_s;
  const double of_log = options.seconds > 0 ? options.seconds : HUGE_VAL;
  const Workload work = !options.log.log.empty() ? log_workload(options.rig, options.log, of_log)
                        : !options.rig.empty()   ? rig_workload(options.rig, seconds)
                                                 : formula_workload(seconds);
  ProgressBar bar;
  return layer_costs(work, [&](double share) { bar.show(share); });
}

void print_table(const BenchResult& result) {
  fmt::print("{:<11}{:>11}{:>10}{:>10}{:>10}{:>10}{:>10}{:>9}{:>15}\n", "layer", "instr/blk", "mean us",
             "p50 us", "p99 us", "p99.9 us", "worst us", "core %", "over deadline");
  for (const LayerCost& c : result.layers)
    fmt::print("{:<11}{:>11}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.2f}{:>9.2f}{:>15}\n", c.name,
               c.instructions_a_block ? fmt::format("{:.0f}", *c.instructions_a_block) : "n/a", c.mean_us,
               c.p50_us, c.p99_us, c.p999_us, c.worst_us, 100 * c.mean_us / result.block_us,
               fmt::format("{} of {}", c.over_deadline, c.blocks));
}

std::string verdict(const BenchResult& result) {
  const double worst = result.engine().worst_us / result.block_us;
  return fmt::format("{}: its worst block takes {:.1f} % of the {:.0f} us that a block of {} frames lasts",
                     worst <= kComfortable ? "fits this machine"
                     : worst <= 1          ? "fits barely, choose a larger block"
                                  : "does not fit this machine, choose a larger block or fewer booms",
                     100 * worst, result.block_us, result.frames);
}

std::string doubt(const BenchResult& result) {
  return fmt::format(
      "the machine was too busy to judge: this process had a core for {:.0f} % of the time (expected 90), "
      "and the "
      "best two runs differ by {:.1f} % (expected at most 5); true figures are lower, try again when it is "
      "quiet",
      100 * result.had, 100 * result.differ);
}

void print_json(const BenchResult& result) {
  Json layers;
  for (const LayerCost& c : result.layers) {
    Json& entry = layers[c.name];
    entry["ns_a_sample"] = 1e3 * c.mean_us / result.frames;
    entry["instructions_a_sample"] =
        c.instructions_a_block ? Json(*c.instructions_a_block / result.frames) : Json();
    entry["mean_block_us"] = c.mean_us;
    entry["p50_block_us"] = c.p50_us;
    entry["p99_block_us"] = c.p99_us;
    entry["p99_9_block_us"] = c.p999_us;
    entry["worst_block_us"] = c.worst_us;
    entry["share_of_core"] = c.mean_us / result.block_us;
    entry["blocks"] = c.blocks;
    entry["over_deadline"] = c.over_deadline;
  }
  Json& engine = layers["engine"];
  engine["block_us"] = result.block_us;
  engine["had_a_core"] = result.had;
  engine["best_runs_differ"] = result.differ;
  engine["quiet"] = result.quiet();
  print_document(layers);
}

void run(const BenchArguments& options) {
  if (options.log.log == "-")
    throw cli::UsageError("--log",
                          "standard input can be read once, expected a file: every run reads it again");
  if (!options.log.log.empty() && options.rig.empty())
    throw cli::UsageError("--log", "needs the --rig whose signals it holds");
  const BenchResult result = measured(options);
  if (options.json) {
    print_json(result);
  } else {
    print_table(result);
    fmt::print("\n{}\n", verdict(result));
  }
  if (!result.quiet()) fmt::print(stderr, "{}\n", doubt(result));
}

}  // namespace

void add_bench(cli::Verb& program) {
  cli::Verb verb = program.verb("bench", "Measure whether a rig fits this machine, and what each layer costs")
                       .group(kInspect);
  auto options = std::make_shared<BenchArguments>();
  verb.option("--rig", options->rig, "rig to measure; left out: one boom, with sounds made from formulas");
  verb.option("--log", options->log.log,
              "recorded bus that the rig plays; left out: all booms drill at the "
              "normal feed, 1800 r/min");
  add_log_options(verb, options->log);
  verb.option("--seconds", options->seconds, "sound of a run; left out: 6, or the whole log")
      .range(0.1, 3600, "s");
  verb.flag("--json", options->json, "figures as one JSON document instead of a table");
  verb.details(
      "Six runs play the same, so a block costs the same in each: what counts is the least processor time "
      "that it "
      "took, not what other programs took from it. Mean, percentiles and worst block are those of these "
      "times; a "
      "layer's are what blocks cost with it less what they cost without it. instr/blk: instructions, where "
      "the "
      "processor counts them. core %: share of one core. The worst block decides whether a rig fits; with "
      "--log "
      "starts and changes count as well.");
  verb.example("rigsound bench --rig config/rigs/demo.toml --log config/logs/shift.log");
  verb.example("rigsound bench --json");
  verb.callback([options] { run(*options); });
}

}  // namespace rigsound::tools
