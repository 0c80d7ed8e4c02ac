#include "engine/tool/tool_energy.hpp"

#include <algorithm>

#include "engine/tool/tool_sounds.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::tests {
namespace {

using namespace tool;

enum class Stretch { kFullReflections, kAnyReflections, kAnySections };

/// Where a family's designed sections sit in the lanes, and what they were designed to be.
struct Placed {
  const Allpass& allpass;
  Seats seats;
  int width;

  int lane(int section) const { return seats.lane(seats.end - allpass.stages() + section, width); }
};

Placed placed(const Allpass& allpass, const BarState& state, Family family, dsp::LaneWidth lanes) {
  return {allpass, state.seats[family], static_cast<int>(lanes)};
}

void redraw(const Placed& at, SectionLanes& lanes, const dsp::RandomField& random, std::uint64_t sample,
            std::uint64_t field) {
  for (int s = 0; s < at.allpass.sections; ++s, field += 2) {
    const auto [b, c] = at.allpass.section[static_cast<std::size_t>(s)];
    set_section(lanes, at.lane(s), b * dsp::exp(2 * random.uniform(sample, field) - 1),
                c * dsp::exp(4 * random.uniform(sample, field + 1) - 2));
  }
}

}  // namespace

double largest_energy_growth(const ToolDesign& design, dsp::LaneWidth width, int samples) {
  BarLoops bar(design, 800, width);
  const Placed T = placed(design.transversal.allpass, bar.state(), kTransversal, width);
  const Placed L = placed(design.longitudinal.allpass, bar.state(), kLongitudinal, width);
  const dsp::RandomField random(7, 1);
  Curves curves(1, 1);
  double out[kChunk], before = 0, worst = -1;
  for (int i = 0; i < samples; ++i) {
    const auto n = static_cast<std::uint64_t>(i);
    const auto stretch = static_cast<Stretch>(i / 2000 % 3);
    const bool hit = bar.asleep();
    curves.x[0] = hit;
    for (double* k : {curves.k_T, curves.k_L}) {
      const double u = 2 * random.uniform(n, k == curves.k_T ? 0 : 1) - 1;
      k[0] = stretch == Stretch::kAnyReflections ? u : u < 0 ? -1 : 1;
    }
    if (stretch == Stretch::kAnySections) {
      redraw(T, bar.state().sections, random, n, 10);
      redraw(L, bar.state().sections, random, n, 60);
    }
    bar.process(curves.drive(1), out);
    const double after = energy(bar.state());
    if (!hit) worst = std::max(worst, after / before - 1);
    before = after;
  }
  return worst;
}

}  // namespace rigsound::tests
