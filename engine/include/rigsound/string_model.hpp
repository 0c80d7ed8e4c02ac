// The drill string that rings: its rods and sleeves, how it is struck, how it sounds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rigsound/machine/fields.hpp"

namespace rigsound {

constexpr int kMaxRods = 20;  ///< on one string

/// Everything a string file says. A string is a shank (the hammer strikes its free end), then `rods` equal
/// rods, each in a coupling sleeve with what is above it; a sleeve covers the ends that meet in its middle,
/// so it adds nothing to the length. The bit stands on the rock. Every decay time is a T60.
struct StringModel {
  std::string name;

  double rod_length_m = 3.66;
  double rod_diameter_m = 0.038;  ///< at most a tenth of the length
  int rods = 1;                   ///< what a layer starts with and what the lists of modes are of
  double shank_length_m = 0.5;    ///< 0: the hammer strikes the first rod
  double sleeve_impedance = 1.6;  ///< of the rod's; 1: no sleeves
  double sleeve_length_m = 0.2;

  double string_low_s = 1.5;   ///< longitudinal waves of the free string at 500 Hz
  double string_high_s = 0.6;  ///< at 5 kHz, at most string_low_s; a long string may ring longer than that
  double guided_s = 0.25;      ///< what the waves of a string lose to chuck and guides while the feed presses
                               ///< it, if that were all
  double bending_low_s = 2.5;  ///< bending of the free rod at 200 Hz
  double bending_high_s = 0.6;   ///< at 8 kHz, at most bending_low_s
  double contact_low_s = 0.25;   ///< bending while the feed presses the bit onto the rock, 200 Hz,
                                 ///< at most bending_low_s
  double contact_high_s = 0.08;  ///< at 8 kHz, at most contact_low_s and bending_high_s

  double strike_width_s = 0.0002;    ///< Hann pulse
  double amplitude_variation = 0.1;  ///< +- share of a strike's amplitude
  int bounces = 1;                   ///< of the piston after a blow
  double bounce_gap = 0.07;          ///< share of the period between them
  double bounce_ratio = 0.3;         ///< amplitude against the one before
  double snap_db = 18;               ///< of the pulse of a breaking rod over a mean blow's

  double string_mix = 1, bending_mix = 0.15;  ///< linear weights
  double highpass_hz = 300;                   ///< -6.02 dB point of a first-order high-pass
  double level = 0.12;  ///< linear, of everything; at the mix's -12 dB it supports recorded clicks
};

template <class Archive>
void fields(Archive& a, StringModel& o) {
  constexpr Range kTimes{0.02, 30, "s"}, kWeights{0, 10};
  a("rod_length_m", o.rod_length_m, Range{0.6, 6.4, "m"});
  a("rod_diameter_m", o.rod_diameter_m, Range{0.025, 0.076, "m"});
  a("rods", o.rods, Range{1, kMaxRods});
  a("shank_length_m", o.shank_length_m, Range{0.4, 1, "m"}.or_zero());
  a("sleeve_impedance", o.sleeve_impedance, Range{1, 2.5});
  a("sleeve_length_m", o.sleeve_length_m, Range{0.15, 0.25, "m"});
  a("string_low_s", o.string_low_s, kTimes);
  a("string_high_s", o.string_high_s, kTimes);
  a("guided_s", o.guided_s, kTimes);
  a("bending_low_s", o.bending_low_s, kTimes);
  a("bending_high_s", o.bending_high_s, kTimes);
  a("contact_low_s", o.contact_low_s, kTimes);
  a("contact_high_s", o.contact_high_s, kTimes);
  a("strike_width_s", o.strike_width_s, Range{0.00005, 0.002, "s"});
  a("amplitude_variation", o.amplitude_variation, Range{0, 1});
  a("bounces", o.bounces, Range{0, 4});
  a("bounce_gap", o.bounce_gap, Range{0.01, 0.2});
  a("bounce_ratio", o.bounce_ratio, Range{0, 1});
  a("snap_db", o.snap_db, Range{0, 30, "dB"});
  a("string_mix", o.string_mix, kWeights);
  a("bending_mix", o.bending_mix, kWeights);
  a("highpass_hz", o.highpass_hz, Range{10, 8000, "Hz"});
  a("level", o.level, kWeights);
}

/// Refuses nonsense, so that nothing can go wrong while the string plays. Throws InvalidField.
/// Thread: OFF, CT.
void require_valid(const StringModel& model);

/// One mode as physics has it and as the layer plays it.
struct StringMode {
  std::string_view family;  ///< "longitudinal" or "bending"
  int mode = 1;
  double target_hz = 0, model_hz = 0, error_cents = 0;
  double t60_s = 0;          ///< as the layer plays it, free
  double t60_pressed_s = 0;  ///< and with the bit pressed onto the rock by full feed
};

/// The modes of model.rods rods at `sample_rate` (Hz), family by family, rising: of the free string up to
/// 6 kHz, exact one-dimensional scattering at its joints, and of the rod as far as `exposed_m` (m, 4
/// diameters
/// ...rod_length_m) of it is out of the hole, free-free Timoshenko up to 12 kHz. Throws std::invalid_argument
/// as require_valid() does. Thread: OFF, CT.
std::vector<StringMode> string_modes(const StringModel& model, double exposed_m, double sample_rate);

/// How long the bit takes to load rock of `stiffness_n_per_m` (N/m, > 0), s: T = Z / k. Thread: OFF, CT.
double loading_time_s(const StringModel& model, double stiffness_n_per_m);

/// Share of a rectangular pulse's energy that the bit sends back, x = pulse length / loading time > 0: rock
/// that loads like a spring and unloads stiffly. 1 without contact, least (0.1855) at x = 1.256, 1 on a rigid
/// wall. Thread: OFF, CT.
double reflected_energy(double x);

/// Share of a strike's energy that a coupling sleeve lets through. Thread: OFF, CT.
double joint_transmission(const StringModel& model);

/// How often the energy of a strike passes a string of one rod until rock of `stiffness_n_per_m` (N/m, > 0),
/// chuck and guides have taken it: 1 over one minus the share kept on a round trip. What passes is heard.
/// Thread: OFF, CT.
double energy_passes(const StringModel& model, double stiffness_n_per_m);

/// What became of a pulse at the bit.
struct BitReflection {
  double energy = 1;  ///< share sent back
  double force = 0;   ///< largest on the rock, as a multiple of the pulse's largest sample
};

/// As the layer plays it: force waves `pulse`, one a sample, not all zero, meet a bit that stands on rock
/// which takes `loading_samples` (> 0) to load. Thread: OFF, CT.
BitReflection played_reflection(const std::vector<double>& pulse, double loading_samples);

}  // namespace rigsound
