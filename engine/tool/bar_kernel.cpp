#include "tool/bar_kernel.hpp"

#define RIGSOUND_LANES 2
#include "tool/bar_kernel_lanes.hpp"

#ifdef RIGSOUND_AVX2
#include "tool/bar_kernel_four.hpp"
#endif

namespace rigsound::tool {

LaneWidth widest_lanes() noexcept {
#ifdef RIGSOUND_AVX2
  if (__builtin_cpu_supports("avx2")) return LaneWidth::kFour;
#endif
  return LaneWidth::kTwo;
}

BarKernel section_kernel(const int (&vectors)[2], [[maybe_unused]] LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == LaneWidth::kFour) return section_kernel_four(vectors[kTransversal]);
#endif
  return vectors[kLongitudinal] == 1 ? with_transversal<1>(vectors[kTransversal])
                                     : with_transversal<2>(vectors[kTransversal]);
}

BarKernel paper_kernel([[maybe_unused]] LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == LaneWidth::kFour) return paper_kernel_four();
#endif
  return run_paper;
}

void run_paper_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept {
  PaperLanes& lanes = state.paper;
  Glue glue(state, drive, out);
  for (int i = 0; i < drive.frames; ++i) {
    double v = glue.from_delay(kTransversal);
    for (int j = 0; j < state.vectors[kTransversal]; ++j) {
      const double y = lanes.lambda * v + lanes.s[j];
      lanes.s[j] = v - lanes.lambda * y;
      v = y;
    }
    glue.close(i, V2{v, glue.from_delay(kLongitudinal)});
  }
}

}  // namespace rigsound::tool
