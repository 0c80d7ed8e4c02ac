#include "tool/bar_loops.hpp"

#include <algorithm>
#include <cmath>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::tool {
namespace {

constexpr double kSilent = 1e-24;     // energy below which a bar that is not struck goes to sleep
constexpr double kNearSilent = 1e-9;  // output above which its energy need not be asked for

int vectors_for(int lanes, int width) noexcept { return (lanes + width - 1) / width; }

int stages_of(const LoopDesign& loop) noexcept { return std::max(1, loop.allpass.stages()); }

}  // namespace

BarLoops::BarLoops(const ToolDesign& design, double highpass_hz, dsp::LaneWidth width) noexcept {
  if (design.transversal.allpass.first_orders > 1) {
    place_paper_loops(design, width);
  } else {
    seat(stages_of(design.transversal), stages_of(design.longitudinal), static_cast<int>(width));
    if (skew_fits(design.transversal, kTransversal) && skew_fits(design.longitudinal, kLongitudinal)) {
      place_sections(design.transversal, kTransversal, static_cast<int>(width));
      place_sections(design.longitudinal, kLongitudinal, static_cast<int>(width));
      kernel_ = section_kernel(state_.seats, width);
    } else {
      place_sequence(design);
    }
  }
  const double t = std::sqrt(3.0) * dsp::tan(dsp::kPi * highpass_hz / design.sample_rate);
  state_.hp_p = (1 - t) / (1 + t);
  state_.hp_b = (1 + state_.hp_p) / 2;
  state_.at = reach(state_);
  state_.line_end = reach(state_) + kLineSlack;
}

/// Together where that takes fewer vectors, else one family after the other.
void BarLoops::seat(int stages_T, int stages_L, int width) noexcept {
  const int own_T = vectors_for(stages_T, width), own_L = vectors_for(stages_L, width);
  const int together = std::max(stages_L, vectors_for(stages_T, width - 1));
  if (together < own_T + own_L && together <= width) {
    state_.seats[kTransversal] = {0, together, together, width * together};
    state_.seats[kLongitudinal] = {0, together, 0, together};
  } else {
    state_.seats[kTransversal] = {0, own_T, 0, width * own_T};
    state_.seats[kLongitudinal] = {own_T, own_L, 0, width * own_L};
  }
}

bool BarLoops::skew_fits(const LoopDesign& loop, Family family) const noexcept {
  return loop.delay_samples > state_.seats[family].skew();
}

/// Lane by lane, where a delay line is shorter than the skew.
void BarLoops::place_sequence(const ToolDesign& design) noexcept {
  const int stages_T = stages_of(design.transversal), stages_L = stages_of(design.longitudinal);
  state_.seats[kTransversal] = {0, stages_T, 0, stages_T};
  state_.seats[kLongitudinal] = {stages_T, stages_L, 0, stages_L};
  place_sections(design.transversal, kTransversal, 1);
  place_sections(design.longitudinal, kLongitudinal, 1);
  kernel_ = run_sections_in_sequence;
}

void BarLoops::place_sections(const LoopDesign& loop, Family family, int width) noexcept {
  const Allpass& allpass = loop.allpass;
  const Seats& seats = state_.seats[family];
  const int begin = seats.end - stages_of(loop);
  const auto place = [&](int slot, double b, double c) {
    set_section(state_.sections, seats.lane(slot, width), b, c);
  };
  for (int slot = seats.first; slot < seats.end; ++slot) place(slot, 0, 0);
  for (int i = 0; i < allpass.sections; ++i) {
    const auto [b, c] = allpass.section[static_cast<std::size_t>(i)];
    place(begin + i, b, c);
  }
  if (allpass.first_orders) place(begin + allpass.sections, allpass.a, 0);
  state_.last[family] = seats.lane(seats.end - 1, width);
  state_.delay[family] = loop.delay_samples - (width > 1 ? seats.skew() : 0);
  place_filters(loop, family, allpass.first_orders ? -1 : 1);
}

void BarLoops::place_paper_loops(const ToolDesign& design, dsp::LaneWidth width) noexcept {
  const int w = static_cast<int>(width), M = design.transversal.allpass.first_orders;
  const int N_T = design.transversal.delay_samples;
  const double a = design.transversal.allpass.a;
  state_.paper.lambda = (a - 1) / (a + 1);
  state_.last[kLongitudinal] = -1;
  state_.delay[kLongitudinal] = design.longitudinal.delay_samples;
  if (N_T < M) {
    kernel_ = run_paper_in_sequence;
    state_.seats[kTransversal] = {0, M, 0, M};
    state_.last[kTransversal] = M - 1;
    state_.delay[kTransversal] = N_T;
  } else {
    const int vectors = vectors_for(M, w);
    kernel_ = paper_kernel(vectors, width);
    state_.seats[kTransversal] = {0, vectors, 0, w * vectors};
    const int first = w * vectors - M;
    state_.paper.entry[first % vectors][first / vectors] = ~std::uint64_t{0};
    state_.last[kTransversal] = w * vectors - 1;
    state_.delay[kTransversal] = N_T - (M - 1);
  }
  place_filters(design.transversal, kTransversal, 1);
  place_filters(design.longitudinal, kLongitudinal, 1);
}

void BarLoops::place_filters(const LoopDesign& loop, Family family, double sign) noexcept {
  const LoopFilters& f = loop.filters;
  state_.dc_r[family] = (1 - f.dc) / (1 + f.dc);
  const double gain = sign * dc_gain(state_.dc_r[family]);
  state_.sh_0[family] = gain * ((f.shelf + f.shelf_gain) / (f.shelf + 1));
  state_.sh_1[family] = gain * ((f.shelf - f.shelf_gain) / (f.shelf + 1));
  state_.sh_q[family] = (1 - f.shelf) / (1 + f.shelf);
}

void BarLoops::process(const BarDrive& drive, double* out) noexcept {
  if (asleep_ && !drive.struck) {
    std::fill(out, out + drive.frames, 0.0);
    return;
  }
  asleep_ = false;
  make_room(state_, drive.frames);
  kernel_(state_, drive, out);
  if (!drive.struck && std::fabs(out[drive.frames - 1]) < kNearSilent && energy(state_) < kSilent) reset();
}

void BarLoops::reset() noexcept {
  silence(state_);
  asleep_ = true;
}

}  // namespace rigsound::tool
