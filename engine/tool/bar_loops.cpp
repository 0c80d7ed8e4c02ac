#include "tool/bar_loops.hpp"

#include <algorithm>
#include <cmath>

#include "dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

constexpr double kSilent = 1e-24;     // energy below which a bar that is not struck goes to sleep
constexpr double kNearSilent = 1e-9;  // output above which its energy need not be asked for

bool struck(const BarDrive& drive) noexcept {
  return std::any_of(drive.x, drive.x + drive.frames, [](double x) { return x != 0; });
}

int vectors_for(int lanes, int width) noexcept { return (lanes + width - 1) / width; }

}  // namespace

BarLoops::BarLoops(const ToolDesign& design, double highpass_hz, LaneWidth width) noexcept {
  if (design.transversal.allpass.first_orders > 1) {
    place_paper_loops(design, width);
  } else {
    place_sections(design.transversal, kTransversal, static_cast<int>(width));
    place_sections(design.longitudinal, kLongitudinal, static_cast<int>(width));
    kernel_ = section_kernel(state_.vectors, width);
  }
  const double t = std::sqrt(3.0) * dsp::tan(dsp::kPi * highpass_hz / design.sample_rate);
  state_.hp_p = (1 - t) / (1 + t);
  state_.hp_b = (1 + state_.hp_p) / 2;
}

void BarLoops::place_sections(const LoopDesign& loop, Family family, int width) noexcept {
  const Allpass& allpass = loop.allpass;
  const int stages = std::max(1, allpass.stages());
  const int before = family == kLongitudinal ? width * state_.vectors[kTransversal] : 0;
  state_.vectors[family] = vectors_for(stages, width);
  state_.last[family] = before + width * state_.vectors[family] - 1;
  const int first = state_.last[family] + 1 - stages;
  for (int lane = before; lane <= state_.last[family]; ++lane) set_section(state_.sections, lane, 0, 0);
  for (int i = 0; i < allpass.sections; ++i)
    set_section(state_.sections, first + i, allpass.section[static_cast<std::size_t>(i)].b,
                allpass.section[static_cast<std::size_t>(i)].c);
  if (allpass.first_orders) set_section(state_.sections, state_.last[family], allpass.a, 0);
  state_.entry[family][first - before] = ~std::uint64_t{0};
  state_.delay[family] = static_cast<unsigned>(loop.N - (stages - 1));
  place_filters(loop, family, allpass.first_orders ? -1 : 1);
}

void BarLoops::place_paper_loops(const ToolDesign& design, LaneWidth width) noexcept {
  const int w = static_cast<int>(width), M = design.transversal.allpass.first_orders;
  const int N_T = design.transversal.N, lanes = w * vectors_for(M, w);
  const double a = design.transversal.allpass.a;
  state_.paper.lambda = (a - 1) / (a + 1);
  state_.last[kLongitudinal] = -1;
  state_.delay[kLongitudinal] = static_cast<unsigned>(design.longitudinal.N);
  if (N_T < M) {
    kernel_ = run_paper_in_sequence;
    state_.vectors[kTransversal] = M;
    state_.last[kTransversal] = M - 1;
    state_.delay[kTransversal] = static_cast<unsigned>(N_T);
  } else {
    kernel_ = paper_kernel(width);
    state_.vectors[kTransversal] = lanes / w;
    state_.last[kTransversal] = lanes - 1;
    state_.delay[kTransversal] = static_cast<unsigned>(N_T - (M - 1));
    state_.entry[kTransversal][lanes - M] = ~std::uint64_t{0};
  }
  place_filters(design.transversal, kTransversal, 1);
  place_filters(design.longitudinal, kLongitudinal, 1);
}

void BarLoops::place_filters(const LoopDesign& loop, Family family, double sign) noexcept {
  const LoopFilters& f = loop.filters;
  state_.dc_d[family] = sign / (1 + f.dc);
  state_.dc_r[family] = (1 - f.dc) / (1 + f.dc);
  state_.sh_0[family] = (f.shelf + f.g) / (f.shelf + 1);
  state_.sh_1[family] = (f.shelf - f.g) / (f.shelf + 1);
  state_.sh_q[family] = (1 - f.shelf) / (1 + f.shelf);
}

void BarLoops::process(const BarDrive& drive, double* out) noexcept {
  const bool hit = struck(drive);
  if (asleep_ && !hit) {
    std::fill(out, out + drive.frames, 0.0);
    return;
  }
  asleep_ = false;
  kernel_(state_, drive, out);
  if (!hit && std::fabs(out[drive.frames - 1]) < kNearSilent && energy(state_) < kSilent) {
    silence(state_);
    asleep_ = true;
  }
}

}  // namespace rigsound::tool
