#include <stdexcept>
#include <string>

#include "rigsound/string_model.hpp"

namespace rigsound {
namespace {

/// NaN fails every comparison, so it is refused everywhere.
void require(bool fine, const char* complaint) {
  if (!fine) throw std::invalid_argument(complaint);
}

bool between(double value, double low, double high) { return value >= low && value <= high; }

void check_steel(const StringModel& m) {
  require(between(m.rod_length_m, 0.6, 6.4), "rod_length_m: out of range, expected 0.6...6.4 m");
  require(between(m.rod_diameter_m, 0.025, 0.076), "rod_diameter_m: out of range, expected 0.025...0.076 m");
  require(m.rod_diameter_m <= m.rod_length_m / 10,
          "rod_diameter_m: too thick for its length, expected at most a tenth of rod_length_m");
  require(m.rods >= 1 && m.rods <= kMaxRods, "rods: out of range, expected 1...20");
  require(m.shank_length_m == 0 || between(m.shank_length_m, 0.4, 1),
          "shank_length_m: out of range, expected 0.4...1 m, or 0 for none");
  require(between(m.sleeve_impedance, 1, 2.5), "sleeve_impedance: out of range, expected 1...2.5");
  require(between(m.sleeve_length_m, 0.15, 0.25), "sleeve_length_m: out of range, expected 0.15...0.25 m");
}

void check_decays(const StringModel& m) {
  require(between(m.string_low_s, 0.02, 30), "string_low_s: out of range, expected 0.02...30 s");
  require(between(m.string_high_s, 0.02, m.string_low_s),
          "string_high_s: out of range, expected 0.02 s...string_low_s");
  require(between(m.guided_s, 0.02, 30), "guided_s: out of range, expected 0.02...30 s");
  require(between(m.bending_low_s, 0.02, 30), "bending_low_s: out of range, expected 0.02...30 s");
  require(between(m.bending_high_s, 0.02, m.bending_low_s),
          "bending_high_s: out of range, expected 0.02 s...bending_low_s");
  require(between(m.contact_low_s, 0.02, m.bending_low_s),
          "contact_low_s: out of range, expected 0.02 s...bending_low_s");
  require(between(m.contact_high_s, 0.02, m.contact_low_s) && m.contact_high_s <= m.bending_high_s,
          "contact_high_s: out of range, expected 0.02 s...contact_low_s and ...bending_high_s");
}

void check_strike(const StringModel& m) {
  require(between(m.strike_width_s, 0.00005, 0.002),
          "strike_width_s: out of range, expected 0.00005...0.002 s");
  require(between(m.amplitude_variation, 0, 1), "amplitude_variation: out of range, expected 0...1");
  require(m.bounces >= 0 && m.bounces <= 4, "bounces: out of range, expected 0...4");
  require(between(m.bounce_gap, 0.01, 0.2), "bounce_gap: out of range, expected 0.01...0.2");
  require(between(m.bounce_ratio, 0, 1), "bounce_ratio: out of range, expected 0...1");
  require(between(m.snap_db, 0, 30), "snap_db: out of range, expected 0...30 dB");
}

void check_voicing(const StringModel& m) {
  require(between(m.string_mix, 0, 10), "string_mix: out of range, expected 0...10");
  require(between(m.bending_mix, 0, 10), "bending_mix: out of range, expected 0...10");
  require(between(m.highpass_hz, 10, 8000), "highpass_hz: out of range, expected 10...8000 Hz");
  require(between(m.level, 0, 10), "level: out of range, expected 0...10");
}

}  // namespace

void require_valid(const StringModel& model) {
  check_steel(model);
  check_decays(model);
  check_strike(model);
  check_voicing(model);
}

}  // namespace rigsound
