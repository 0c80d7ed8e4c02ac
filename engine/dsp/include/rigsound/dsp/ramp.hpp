// How a control gets from one value to the next without a step: the only ramps of the engine.
#pragma once

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {

/// A straight line over the `count` samples of one chunk; the last sample reaches `to`. Thread: RT.
struct Ramp {
  double from = 0, to = 0;

  /// Value at sample `n` of `count`.
  double at(int n, int count) const noexcept { return from + (to - from) * (n + 1.0) / count; }

  /// The next chunk goes from where this one ends to `target`.
  void go_to(double target) noexcept { from = to, to = target; }

  bool rests_at(double value) const noexcept { return from == value && to == value; }
};

/// x[n], numbers or Lanes, times the ramp. Thread: RT.
template <class Sample>
void scale(const Ramp& ramp, Sample* x, int count) noexcept {
  const double from = ramp.from, step = (ramp.to - from) / count;
  if (step == 0)
    for (int n = 0; n < count; ++n) x[n] *= from;
  else
    for (int n = 0; n < count; ++n) x[n] *= from + step * (n + 1);
}

/// y[n] += ramp times x[n], numbers of either size, `count` even. Thread: RT.
template <class Sample>
void add_scaled(const Ramp& ramp, const Sample* x, double* y, int count) noexcept {
  const double step = (ramp.to - ramp.from) / count;
  Lanes place = {1, 2};
  for (int n = 0; n < count; n += 2, place += 2.0)
    store(y + n, load(y + n) + (ramp.from + step * place) * load(x + n));
}

/// The share of its way that a one-pole smoother of time constant `time_s` has still to go after `samples`:
/// y = target + (y - target) * remainder. Thread: any.
inline double one_pole_remainder(double time_s, double samples, double sample_rate) noexcept {
  return exp(-samples / (time_s * sample_rate));
}

/// One step of such a smoother. A value that is no number is at once where it shall go. Thread: RT.
inline double approached(double value, double target, double remainder) noexcept {
  const double next = target + (value - target) * remainder;
  return next - next == 0 ? next : target;
}

/// `from`, moved towards `to` by `step` at most. Thread: RT.
inline double step_towards(double from, double to, double step) noexcept {
  return from < to ? std::min(to, from + step) : std::max(to, from - step);
}

}  // namespace rigsound::dsp
