#include "tool/bar_state.hpp"

#include <cmath>
#include <cstring>

namespace rigsound::tool {

void set_section(SectionLanes& lanes, int lane, double b, double c) noexcept {
  const double q = 2 / (1 + b + c);
  lanes.h[lane] = std::sqrt(b);
  lanes.e[lane] = std::sqrt(c);
  lanes.g0[lane] = q;
  lanes.g1[lane] = q * lanes.e[lane];
  lanes.g2[lane] = q * lanes.h[lane];
}

namespace {

/// Storage of the first-order filters in terms of their running sums. a = (1 - pole) / (1 + pole) is the
/// analog corner; both filters are made of the allpass (a - p) / (a + p), whose state's square this is:
/// s^2 (1 + a)^2 / a, halved for the DC blocker, over 2 (1 - g) for the shelf.
double glue_energy(const BarState& s, int f) noexcept {
  const auto allpass_energy = [](double sum, double pole) {
    const double a = (1 - pole) / (1 + pole);
    return sum * sum * (1 + a) * (1 + a) / a;
  };
  const double corner = (1 - s.sh_q[f]) / (1 + s.sh_q[f]);
  const double g = s.sh_0[f] * (1 + corner) - corner;
  const double shelf = g < 1 ? allpass_energy(s.sh_s[f], s.sh_q[f]) / (2 * (1 - g)) : 0;
  return allpass_energy(s.dc_s[f], s.dc_r[f]) / 2 + shelf;
}

}  // namespace

double energy(const BarState& s) noexcept {
  double sum = glue_energy(s, kTransversal) + glue_energy(s, kLongitudinal);
  for (int f = 0; f < 2; ++f)
    for (unsigned d = 1; d <= s.delay[f]; ++d) {
      const double y = s.ring[(s.at - d) % kRing][f];
      sum += y * y;
    }
  const auto in_flight = [&s](int lane, double y) {
    return lane == s.last[kTransversal] || lane == s.last[kLongitudinal] ? 0 : y * y;
  };
  for (int i = 0; i < kLanes; ++i) {
    const SectionLanes& l = s.sections;
    sum += (l.x1[i] * l.x1[i] + l.x2[i] * l.x2[i]) + in_flight(i, l.y[i]);
  }
  const double per_square = 1 / (1 - s.paper.lambda * s.paper.lambda);
  for (int i = 0; i < kPaperLanes; ++i)
    sum += s.paper.s[i] * s.paper.s[i] * per_square + in_flight(i, s.paper.y[i]);
  return sum;
}

void silence(BarState& s) noexcept {
  std::memset(s.ring, 0, sizeof s.ring);
  for (double* lanes : {s.sections.x1, s.sections.x2, s.sections.y})
    std::memset(lanes, 0, sizeof s.sections.y);
  std::memset(s.paper.s, 0, sizeof s.paper.s);
  std::memset(s.paper.y, 0, sizeof s.paper.y);
  for (double* pair : {s.dc_s, s.sh_s}) pair[0] = pair[1] = 0;
  s.hp_m = s.hp_out = 0;
}

}  // namespace rigsound::tool
