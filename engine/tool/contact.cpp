#include "tool/contact.hpp"

#include <algorithm>

#include "rigsound/dsp/lanes.hpp"

namespace rigsound::tool {

Contact::Contact(const LoopDesign& loop, const Strike& strike, double sample_rate) noexcept
    : k_min_(loop.reflection_min),
      k_max_(loop.reflection_max),
      fall_((loop.reflection_max - loop.reflection_min) / (strike.fall_s * sample_rate)),
      rise_((loop.reflection_max - loop.reflection_min) / (strike.rise_s * sample_rate)),
      k_(loop.reflection_max) {}

/// Goes straight to `target` and stops there; returns the sample after the one that reached it.
int Contact::ramp(int from, int to, double target, double step, double* k_T) noexcept {
  const double steps = (target - k_) / step;  // how many samples it takes, not rounded
  const int until = steps < to - from ? from + static_cast<int>(steps) : to;
  const double start = k_;
  // Each from the start, not from the one before: no sample waits for another.
  int n = from;
  for (dsp::Lanes place = {1, 2}; n + 1 < until; n += 2, place += 2.0)
    dsp::store(k_T + n, start + place * step);
  if (n < until) k_T[n] = start + (n + 1 - from) * step;
  k_ = until < to ? target : start + (to - from) * step;
  if (until == to) return to;
  k_T[until] = target;
  return until + 1;
}

void Contact::advance(int from, int to, double* k_T) noexcept {
  if (falling_) {
    from = ramp(from, to, k_min_, -slope_ * fall_, k_T);
    if (k_ > k_min_) return;
    falling_ = false;
  }
  if (k_ < k_max_) from = ramp(from, to, k_max_, slope_ * rise_, k_T);
  std::fill(k_T + from, k_T + to, k_max_);
}

void Contact::process(const Strikes& strikes, double* k_T) noexcept {
  int done = 0;
  for (const Touch& touch : strikes) {
    advance(done, touch.at, k_T);
    done = touch.at;
    slope_ = touch.slope;
    falling_ = k_max_ > k_min_;
  }
  advance(done, kChunk, k_T);
}

}  // namespace rigsound::tool
