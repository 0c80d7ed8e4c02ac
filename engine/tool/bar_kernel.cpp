#include "tool/bar_kernel.hpp"

#define RIGSOUND_LANES 2
#include "tool/bar_kernel_lanes.hpp"

#ifdef RIGSOUND_AVX2
#include "tool/bar_kernel_four.hpp"
#endif

namespace rigsound::tool {
namespace {

/// `bar`: the transversal and the longitudinal sample after their cascades, from what the delay lines give
/// out.
template <class Bar>
void run_in_sequence(BarState& state, const BarDrive& drive, double* out, Bar bar) noexcept {
  Glue glue(state, drive);
  Taps taps(state);
  for (int i = 0; i < drive.frames; ++i, taps.advance()) out[i] = glue.close(i, bar(taps), taps.now);
  glue.keep(state, drive.frames);
}

}  // namespace

BarKernel section_kernel(const Seats (&seats)[2], [[maybe_unused]] dsp::LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == dsp::LaneWidth::kFour) return section_kernel_four(seats);
#endif
  const int vectors_T = seats[kTransversal].vectors;
  if (seats[kLongitudinal].base == 0) return sections_with<0>(vectors_T, SharedCounts{});
  return seats[kLongitudinal].vectors == 1 ? sections_with<1>(vectors_T, SectionCounts{})
                                           : sections_with<2>(vectors_T, SectionCounts{});
}

BarKernel paper_kernel(int vectors, [[maybe_unused]] dsp::LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == dsp::LaneWidth::kFour) return paper_kernel_four(vectors);
#endif
  return paper_with(vectors, PaperCounts{});
}

void run_sections_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept {
  SectionLanes& s = state.sections;
  const auto cascade = [&](const Seats& seats, double u) {
    for (int j = seats.base; j < seats.base + seats.vectors; ++j) {
      const double w = s.g0[j] * s.x1[j] - s.g1[j] * s.x2[j], m = w + s.g2[j] * u;
      u = s.c0[j] * u - s.h[j] * w;
      s.x1[j] = m - s.x1[j];
      s.x2[j] = s.x2[j] + m;
    }
    return u;
  };
  run_in_sequence(state, drive, out, [&](const Taps& taps) {
    const double v_T = cascade(state.seats[kTransversal], (*taps.T)[kTransversal]);
    return V2{v_T, cascade(state.seats[kLongitudinal], (*taps.L)[kLongitudinal])};
  });
}

void run_paper_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept {
  double* y_1 = state.paper.y[0];
  run_in_sequence(state, drive, out, [&](const Taps& taps) {
    double u = taps.T[0][kTransversal], u_1 = taps.T[-1][kTransversal];
    for (int j = 0; j < state.seats[kTransversal].vectors; ++j) {
      const double y = state.paper.lambda * (u - y_1[j]) + u_1;
      u_1 = y_1[j];
      y_1[j] = u = y;
    }
    return V2{u, (*taps.L)[kLongitudinal]};
  });
}

}  // namespace rigsound::tool
