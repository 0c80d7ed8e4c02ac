#include "tool/bar_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rigsound::tool {

int reach(const BarState& s) noexcept { return std::max(s.delay[kTransversal], s.delay[kLongitudinal]) + 1; }

void make_room(BarState& s, int frames) noexcept {
  if (s.at + frames <= s.line_end) return;
  const int kept = reach(s);
  std::memmove(s.line, s.line + (s.at - kept), static_cast<std::size_t>(kept) * sizeof *s.line);
  s.at = kept;
}

void set_section(SectionLanes& lanes, int lane, double b, double c) noexcept {
  const double q = 2 / (1 + b + c), e = std::sqrt(c);
  if (e > 0 && lanes.e[lane] > 0) lanes.x2[lane] *= lanes.e[lane] / e;
  lanes.e[lane] = e;
  lanes.h[lane] = std::sqrt(b);
  lanes.g0[lane] = q;
  lanes.g1[lane] = q * c;
  lanes.g2[lane] = q * lanes.h[lane];
  lanes.c0[lane] = ((1 + c) - b) / ((1 + c) + b);
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
  const double gain = dc_gain(s.dc_r[f]), corner = (1 - s.sh_q[f]) / (1 + s.sh_q[f]);
  const double g = std::fabs(s.sh_0[f]) / gain * (1 + corner) - corner;
  const double shelf = g < 1 ? allpass_energy(s.sh_s[f], s.sh_q[f]) / (2 * (1 - g)) : 0;
  return allpass_energy(gain * s.dc_s[f], s.dc_r[f]) / 2 + shelf;
}

/// Bound on what the paper's cascade holds: each section stores (u - lambda y)^2 / (1 - lambda^2).
double paper_energy(const BarState& s) noexcept {
  const double share = (1 + std::fabs(s.paper.lambda)) / (1 - std::fabs(s.paper.lambda));
  double sum = 0;
  for (int i = 0; i < kPaperLanes; ++i)
    sum += s.paper.y[0][i] * s.paper.y[0][i] + s.paper.y[1][i] * s.paper.y[1][i];
  return (1 + share) * sum;
}

}  // namespace

double energy(const BarState& s) noexcept {
  double sum = glue_energy(s, kTransversal) + glue_energy(s, kLongitudinal);
  for (int f = 0; f < 2; ++f)
    for (int d = 1; d <= s.delay[f]; ++d) sum += s.line[s.at - d][f] * s.line[s.at - d][f];
  const auto in_flight = [&s](int lane, double y) {
    return lane == s.last[kTransversal] || lane == s.last[kLongitudinal] ? 0 : y * y;
  };
  const SectionLanes& l = s.sections;
  for (int i = 0; i < kLanes; ++i) {
    const double x2 = l.e[i] * l.x2[i];
    sum += (l.x1[i] * l.x1[i] + x2 * x2) + in_flight(i, l.y[i]);
  }
  return sum + paper_energy(s);
}

void silence(BarState& s) noexcept {
  std::memset(s.line, 0, sizeof s.line);
  for (double* lanes : {s.sections.x1, s.sections.x2, s.sections.y})
    std::memset(lanes, 0, sizeof s.sections.y);
  std::memset(s.paper.y, 0, sizeof s.paper.y);
  for (double* pair : {s.dc_s, s.sh_s, s.hp_r}) pair[0] = pair[1] = 0;
}

}  // namespace rigsound::tool
