// What the engine costs: time a sample, whole and by the number of booms. Ratios of one run are what counts.
#include <benchmark/benchmark.h>

#include <vector>

#include "bench/formula_sounds.hpp"
#include "rigsound/engine.hpp"

using namespace rigsound;

namespace {

void run(benchmark::State& bench, const EngineOptions& options, double from_second) {
  Engine engine(options, tools::formula_sounds(options.sample_rate));
  std::vector<float> block(static_cast<std::size_t>(options.block * options.channels));
  double second = from_second;
  while (bench.KeepRunning()) {
    engine.process(tools::drilled_hole(second), block.data());
    benchmark::DoNotOptimize(block.data());
    second = second < from_second + 4 ? second + options.block / options.sample_rate : from_second;
  }
  const double samples = static_cast<double>(bench.iterations()) * options.block;
  bench.counters["a_sample"] =
      benchmark::Counter(samples, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.counters["times_realtime"] =
      benchmark::Counter(samples / options.sample_rate, benchmark::Counter::kIsRate);
}

void at_rest(benchmark::State& bench) { run(bench, tools::full_options(), 2); }
void one_boom(benchmark::State& bench) { run(bench, tools::full_options(), 8); }
void two_booms(benchmark::State& bench) { run(bench, tools::full_options(), 16); }
void two_booms_block_256(benchmark::State& bench) { run(bench, tools::full_options(256), 16); }
void rattling(benchmark::State& bench) { run(bench, tools::full_options(), 40); }

}  // namespace

BENCHMARK(at_rest);
BENCHMARK(one_boom);
BENCHMARK(two_booms);
BENCHMARK(two_booms_block_256);
BENCHMARK(rattling);
BENCHMARK_MAIN();
