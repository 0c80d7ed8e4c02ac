#include "bench/stk/stk_runner.hpp"

#include <stk/Delay.h>
#include <stk/PoleZero.h>
#include <stk/Stk.h>

#include <array>

namespace rigsound::bench {
namespace {

constexpr int kSections = 40, kDelayT = 50, kDelayL = 8, kFrames = 32, kChunksABlow = 60;
constexpr double kLambda = -0.618, kReflectionT = 0.89, kReflectionL = 0.94, kMix = 0.5;

stk::PoleZero first_order(double b0, double b1, double a1) {
  stk::PoleZero filter;
  filter.setCoefficients(b0, b1, a1);
  return filter;
}

stk::PoleZero dc_blocker() { return first_order(0.9975, -0.9975, -0.995); }  // eq. 3
stk::PoleZero shelf() { return first_order(0.86, -0.26, -0.40); }

/// y = x + what comes back of y after `delay` samples.
struct Loop {
  Loop(int delay, double reflection) : line(static_cast<unsigned long>(delay - 1), 4095), k(reflection) {}

  template <class Cascade>
  double tick(double x, Cascade&& cascade) {
    const double y = x + back;
    back = k * shelving.tick(blocker.tick(cascade(line.tick(y))));
    return y;
  }

  stk::Delay line;
  stk::PoleZero blocker = dc_blocker(), shelving = shelf();
  double k, back = 0;
};

struct PaperTool {
  PaperTool() {
    for (stk::PoleZero& section : allpass) section.setAllpass(kLambda);  // eq. 4
  }

  double tick(double x) {
    const double y_T = transversal.tick(x, [this](double v) {
      for (stk::PoleZero& section : allpass) v = section.tick(v);
      return v;
    });
    const double y_L = longitudinal.tick(x, [](double v) { return v; });
    return highpass.tick(kMix * y_T + kMix * y_L);
  }

  std::array<stk::PoleZero, kSections> allpass;
  Loop transversal{kDelayT, kReflectionT}, longitudinal{kDelayL, kReflectionL};
  stk::PoleZero highpass = first_order(0.91, -0.91, -0.82);
};

}  // namespace

double run_stk_paper_tool() {
  static PaperTool tool;
  static int chunk = 0;
  const bool struck = chunk++ % kChunksABlow == 0;
  double out = 0;
  for (int n = 0; n < kFrames; ++n) out = tool.tick(struck && n >= 3 && n < 12 ? 1.0 : 0.0);
  return out;
}

}  // namespace rigsound::bench
