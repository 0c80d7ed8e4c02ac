#include "rigsound/machine/state_guard.hpp"

namespace rigsound {
namespace {

float within(float x, float low, float high, float absent) noexcept {
  if (!(x == x)) return absent;
  return x < low ? low : x > high ? high : x;
}

DrillControls guarded(const DrillControls& c) noexcept {
  DrillControls g;
  g.mean_frequency_hz = c.mean_frequency_hz > 0 ? within(c.mean_frequency_hz, 1, 100, 0) : 0;
  g.mean_amplitude_db = within(c.mean_amplitude_db, -60, 24, 0);
  g.deviation_time = within(c.deviation_time, 0, 4, 1);
  g.deviation_amplitude = within(c.deviation_amplitude, 0, 4, 1);
  g.attack_factor = within(c.attack_factor, 0.1f, 10, 1);
  g.decay_factor = within(c.decay_factor, 0.25f, 10, 1);
  return g;
}

}  // namespace

MachineState guarded(const MachineState& s) noexcept {
  MachineState g = s;
  g.engine_rpm = within(s.engine_rpm, 0, 4000, 0);
  g.engine_load = s.engine_load >= 0 ? within(s.engine_load, 0, 1, -1) : -1;
  g.master_gain_db = within(s.master_gain_db, -60, 0, 0);
  g.safety_gain = within(s.safety_gain, 0, 1, 0);
  for (BoomState& b : g.boom) {
    b.feed_pressure_bar = within(b.feed_pressure_bar, 0, 300, 0);
    b.percussion_rate_hz = b.percussion_rate_hz > 0 ? within(b.percussion_rate_hz, 5, 80, 0) : 0;
    if (b.rattling > Rattling::kOpen) b.rattling = Rattling::kNone;
    if (b.percussion > Percussion::kFromFeed) b.percussion = Percussion::kOff;
    b.rod_count = b.rod_count < 1 ? 1 : b.rod_count > 20 ? 20 : b.rod_count;
    b.controls = guarded(b.controls);
  }
  return g;
}

}  // namespace rigsound
