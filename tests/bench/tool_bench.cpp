// Cost of the ringing bar, in nanoseconds a sample: the least of many short runs, every contestant in turn,
// so that what else the machine does hits all alike. The last lines are a ratio of one run: the paper's own
// model here and in Faust (-vec, -O3).
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "rigsound/tool_model.hpp"
#include "tool/bar_loops.hpp"
#include "tool/tool_layer.hpp"

#ifdef RIGSOUND_FAUST
#include "bench/faust/faust_runner.hpp"
#endif

using namespace rigsound;
using namespace rigsound::tool;

namespace {

constexpr int kRounds = 600, kChunksARound = 180;

struct Contestant {
  std::string name;
  std::function<void(int chunk)> run;
  double best_ns = 1e9;
};

double sink = 0;

std::array<double, kChunk> filled(double value) {
  std::array<double, kChunk> a;
  a.fill(value);
  return a;
}

ToolModel model_of(const Bar& bar) {
  ToolModel model;
  model.bar = bar;
  return model;
}

Contestant layer(const std::string& name, const ToolModel& model, LaneWidth width) {
  auto tool = std::make_shared<ToolLayer>(model, 48000, 1, 0, width);
  return {name, [tool](int chunk) {
            double out[kChunk];
            const Impact blow{3.25, 1, static_cast<std::uint64_t>(chunk)};
            tool->process(&blow, chunk % 60 == 0, ToolControls{}, out);
            sink += out[kChunk - 1];
          }};
}

/// The loops alone, excitation and reflections ready made: what the Faust program does.
Contestant loops(const std::string& name, const ToolModel& model, LaneWidth width) {
  auto bar = std::make_shared<BarLoops>(design_tool(model, 48000), 800, width);
  return {name, [bar](int chunk) {
            static const std::array<double, kChunk> silence{}, k_T = filled(0.89), k_L = filled(0.94),
                                                               mix = filled(0.5);
            static const std::array<double, kChunk> blow = [] {
              std::array<double, kChunk> x{};
              std::fill(x.begin() + 3, x.begin() + 12, 1.0);
              return x;
            }();
            const bool struck = chunk % 60 == 0;
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

std::string size_of(const ToolDesign& design) {
  return "T" + std::to_string(design.transversal.allpass.stages()) + "+L" +
         std::to_string(design.longitudinal.allpass.stages());
}

using Make = Contestant (*)(const std::string&, const ToolModel&, LaneWidth);

void add(std::vector<Contestant>& all, Make make, const ToolModel& model, const std::string& name) {
  all.push_back(make(name + ", 2 lanes", model, LaneWidth::kTwo));
  if (widest_lanes() == LaneWidth::kFour) all.push_back(make(name + ", 4 lanes", model, LaneWidth::kFour));
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

}  // namespace

int main() {
  std::vector<Contestant> all;
  for (const Bar bar : {Bar{0.35, 0.030}, Bar{0.5, 0.025}, Bar{0.85, 0.020}, Bar{0.90, 0.020}})
    add(all, layer, model_of(bar), "layer " + size_of(design_tool(model_of(bar), 48000)));
  ToolModel paper = model_of({0.5, 0.025});
  paper.kind = ToolKind::kPaper;
  add(all, layer, paper, "layer, paper M=40");
  add(all, loops, paper, "loops, paper M=40");
#ifdef RIGSOUND_FAUST
  all.push_back({"paper M=40 in Faust", [](int) { sink += bench::run_faust_paper_tool(); }});
#endif
  race(all);
  for (const Contestant& one : all) std::printf("%-28s %7.2f ns a sample\n", one.name.c_str(), one.best_ns);
#ifdef RIGSOUND_FAUST
  for (const Contestant& one : all)
    if (one.name.find("loops") == 0)
      std::printf("%-28s %7.2f times as fast as Faust\n", one.name.c_str(), all.back().best_ns / one.best_ns);
#endif
  return sink == 0.123;  // never, but the compiler cannot know
}
