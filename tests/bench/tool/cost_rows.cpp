// Cost of the ringing bar in nanoseconds a sample, the layer as the daemon runs it: the least of many short
// runs, every contestant in turn, so that what else the machine does hits all alike. The last rows are
// ratios of one run: the paper's own model here, in Faust (-vec, -O3) and on the Synthesis ToolKit (-O3).
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/tool/row.hpp"
#include "bench/tool/rows.hpp"
#include "rigsound/tool_model.hpp"
#include "tool/bar_loops.hpp"
#include "tool/tool_layer.hpp"

#ifdef RIGSOUND_FAUST
#include "bench/faust/faust_runner.hpp"
#endif
#ifdef RIGSOUND_STK
#include "bench/stk/stk_runner.hpp"
#endif

namespace rigsound::bench {
namespace {

using namespace tool;

constexpr double kRate = 48000;
constexpr int kRounds = 3000, kChunksARound = 180, kChunksABlow = 60;

enum class Whose { kLayer, kLoops, kOther };

struct Contestant {
  std::string name;
  Whose whose;
  double wanted_ns, wanted_ratio;  ///< of a layer; how much dearer another program shall be than our loops
  std::function<void(int chunk)> run;
  double best_ns = 1e9;
};

double sink = 0;

std::array<double, kChunk> filled(double value) {
  std::array<double, kChunk> a;
  a.fill(value);
  return a;
}

/// The whole layer, struck every 40 ms.
Contestant layer(const std::string& name, double wanted_ns, const ToolModel& model, dsp::LaneWidth width) {
  auto tool = std::make_shared<ToolLayer>(model, kRate, 1, 0, width);
  return {name, Whose::kLayer, wanted_ns, 0, [tool](int chunk) {
            double out[kChunk];
            const Impact blow{3.25, 1, static_cast<std::uint64_t>(chunk)};
            tool->process(ToolInput{}, {&blow, chunk % kChunksABlow == 0}, out);
            sink += out[kChunk - 1];
          }};
}

/// The loops alone, excitation and reflections ready made: what the Faust program does.
Contestant loops(const std::string& name, const ToolModel& model, dsp::LaneWidth width) {
  auto bar = std::make_shared<BarLoops>(design_tool(model, kRate), 800, width);
  return {name, Whose::kLoops, 0, 0, [bar](int chunk) {
            static const std::array<double, kChunk> silence{}, k_T = filled(0.89), k_L = filled(0.94),
                                                               mix = filled(0.5);
            static const std::array<double, kChunk> blow = [] {
              std::array<double, kChunk> x{};
              std::fill(x.begin() + 3, x.begin() + 12, 1.0);
              return x;
            }();
            const bool struck = chunk % kChunksABlow == 0;
            const BarDrive drive{kChunk,
                                 struck,
                                 struck ? blow.data() : silence.data(),
                                 {k_T.data(), k_L.data()},
                                 {mix.data(), mix.data()}};
            double out[kChunk];
            bar->process(drive, out);
            sink += out[kChunk - 1];
          }};
}

ToolModel paper_model() {
  ToolModel model;
  model.kind = ToolKind::kPaper;
  return model;
}

/// A steel whose loops have this many sections. No bar needs three longitudinal ones beside twelve
/// transversal, so the design is given one more, a first-order one that does next to nothing.
ToolModel sized(const Bar& bar, int stages_T, int stages_L) {
  ToolModel model;
  model.bar = bar;
  ToolDesign design = design_tool(model, kRate);
  LoopDesign& L = design.longitudinal;
  if (L.allpass.stages() < stages_L) ++L.allpass.first_orders, --L.delay_samples;
  if (design.transversal.allpass.stages() != stages_T || L.allpass.stages() != stages_L)
    throw std::logic_error("the designer has changed, choose other bars");
  model.designs = {design};
  return model;
}

std::vector<Contestant> contestants() {
  const ToolModel small = sized({0.5, 0.025}, 6, 2), large = sized({0.8, 0.015}, 12, 3);
  std::vector<Contestant> all = {layer("full model T6+L2, SSE2 -O2", 20, small, dsp::LaneWidth::kTwo),
                                 layer("full model T12+L3, SSE2 -O2", 20, large, dsp::LaneWidth::kTwo),
                                 loops("paper's model M=40, SSE2 -O2", paper_model(), dsp::LaneWidth::kTwo)};
  if (dsp::widest_lanes() == dsp::LaneWidth::kFour) {
    all.push_back(layer("full model T6+L2, AVX2", 9, small, dsp::LaneWidth::kFour));
    all.push_back(layer("full model T12+L3, AVX2", 12, large, dsp::LaneWidth::kFour));
    all.push_back(loops("paper's model M=40, AVX2", paper_model(), dsp::LaneWidth::kFour));
  }
#ifdef RIGSOUND_FAUST
  all.push_back({"Faust, -vec -O3", Whose::kOther, 0, 6, [](int) { sink += run_faust_paper_tool(); }});
#endif
#ifdef RIGSOUND_STK
  all.push_back({"STK, -O3", Whose::kOther, 0, 18, [](int) { sink += run_stk_paper_tool(); }});
#endif
  return all;
}

void race(std::vector<Contestant>& all) {
  for (int round = 0; round < kRounds; ++round)
    for (Contestant& one : all) {
      const auto start = std::chrono::steady_clock::now();
      for (int chunk = 0; chunk < kChunksARound; ++chunk) one.run(chunk);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      one.best_ns = std::min(one.best_ns, took.count() * 1e9 / (kChunksARound * kChunk));
    }
}

void print_ratios(const std::vector<Contestant>& all, const Contestant& other) {
  for (const Contestant& one : all)
    if (one.whose == Whose::kLoops)
      print({one.name + " against " + other.name, Bound::kAtLeast, other.wanted_ratio,
             other.best_ns / one.best_ns, "times"});
}

}  // namespace

void print_cost() {
  std::vector<Contestant> all = contestants();
  race(all);
  for (const Contestant& one : all)
    if (one.whose == Whose::kLayer)
      print({one.name, Bound::kAtMost, one.wanted_ns, one.best_ns, "ns a sample"});
    else
      std::printf("%-66s | %8.2f ns a sample\n", one.name.c_str(), one.best_ns);
  for (const Contestant& one : all)
    if (one.whose == Whose::kOther) print_ratios(all, one);
#ifndef RIGSOUND_FAUST
  std::puts("SKIPPED: tool_bench: ratio to Faust: no faust compiler");
#endif
#ifndef RIGSOUND_STK
  std::puts("SKIPPED: tool_bench: ratio to STK: no libstk-dev");
#endif
  if (sink == 0.123) std::puts("");  // never, but the compiler cannot know
}

}  // namespace rigsound::bench
