#include "bench/faust/faust_runner.hpp"

/// What generated code expects of its surroundings.
struct Meta {
  void declare(const char*, const char*) {}
};
struct UI {
  void openVerticalBox(const char*) {}
  void closeBox() {}
  void declare(float*, const char*, const char*) {}
  void addHorizontalSlider(const char*, float*, float, float, float, float) {}
};
struct dsp {};

#include "paper_tool_faust.hpp"

namespace rigsound::bench {

double run_faust_paper_tool() {
  static PaperTool tool;
  static bool ready = false;
  static int chunk = 0;
  if (!ready) tool.init(48000), ready = true;
  float in[32] = {}, out[32];
  if (chunk++ % 60 == 0)
    for (int i = 3; i < 12; ++i) in[i] = 1;
  float *ins[] = {in}, *outs[] = {out};
  tool.compute(32, ins, outs);
  return static_cast<double>(out[31]);
}

}  // namespace rigsound::bench
