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

BarKernel section_kernel(const Seats (&seats)[2], [[maybe_unused]] LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == LaneWidth::kFour) return section_kernel_four(seats);
#endif
  const int vectors_T = seats[kTransversal].vectors;
  if (seats[kLongitudinal].base == 0) return sections_with<0>(vectors_T, SharedCounts{});
  return seats[kLongitudinal].vectors == 1 ? sections_with<1>(vectors_T, SectionCounts{})
                                           : sections_with<2>(vectors_T, SectionCounts{});
}

BarKernel paper_kernel(int vectors, [[maybe_unused]] LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == LaneWidth::kFour) return paper_kernel_four(vectors);
#endif
  return paper_with(vectors, PaperCounts{});
}

void run_paper_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept {
  Glue glue(state, drive);
  Taps taps(state);
  double* y_1 = state.paper.y[0];
  for (int i = 0; i < drive.frames; ++i, taps.advance()) {
    double u = taps.T[0][kTransversal], u_1 = taps.T[-1][kTransversal];
    for (int j = 0; j < state.seats[kTransversal].vectors; ++j) {
      const double y = state.paper.lambda * (u - y_1[j]) + u_1;
      u_1 = y_1[j];
      y_1[j] = u = y;
    }
    out[i] = glue.close(i, V2{u, (*taps.L)[kLongitudinal]}, taps.now);
  }
  glue.keep(state, drive.frames);
}

}  // namespace rigsound::tool
