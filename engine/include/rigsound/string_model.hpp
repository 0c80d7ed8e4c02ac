// The drill string that rings: its rods and sleeves, how it is struck, how it sounds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigsound {

constexpr int kMaxRods = 20;  ///< on one string

/// Everything a string file says; require_valid() holds every member against the range written here. A string
/// is a shank (the hammer strikes its free end), then `rods` equal rods, each in a coupling sleeve with what
/// is above it; a sleeve covers the ends that meet in its middle, so it adds nothing to the length. The bit
/// stands on the rock. Every decay time is a T60.
struct StringModel {
  std::string name;

  double rod_length_m = 3.66;     ///< 0.6...6.4
  double rod_diameter_m = 0.038;  ///< 0.025...0.076, at most a tenth of the length
  int rods = 1;                 ///< 1...kMaxRods: what a layer starts with and what the lists of modes are of
  double shank_length_m = 0.5;  ///< 0.4...1; 0: the hammer strikes the first rod
  double sleeve_impedance = 1.6;  ///< of the rod's, 1...2.5; 1: no sleeves
  double sleeve_length_m = 0.2;   ///< 0.15...0.25

  double string_low_s = 1.5;   ///< longitudinal waves of the free string at 500 Hz, 0.02...30
  double string_high_s = 0.6;  ///< at 5 kHz, 0.02...string_low_s; a long string may ring longer than that
  double guided_s = 0.25;      ///< what the waves of a string lose to chuck and guides while the feed presses
                               ///< it, if that were all, 0.02...30
  double bending_low_s = 2.5;  ///< bending of the free rod at 200 Hz, 0.02...30
  double bending_high_s = 0.6;   ///< at 8 kHz, 0.02...bending_low_s
  double contact_low_s = 0.25;   ///< bending while the feed presses the bit onto the rock, 200 Hz,
                                 ///< 0.02...bending_low_s
  double contact_high_s = 0.08;  ///< at 8 kHz, 0.02...contact_low_s and ...bending_high_s

  double strike_width_s = 0.0002;    ///< Hann pulse, 0.00005...0.002
  double amplitude_variation = 0.1;  ///< +- share of a strike's amplitude, 0...1
  int bounces = 1;                   ///< of the piston after a blow, 0...4
  double bounce_gap = 0.07;          ///< share of the period between them, 0.01...0.2
  double bounce_ratio = 0.3;         ///< amplitude against the one before, 0...1
  double snap_db = 18;               ///< of the pulse of a breaking rod over a mean blow's, 0...30

  double string_mix = 1, bending_mix = 0.15;  ///< linear weights, 0...10
  double highpass_hz = 300;                   ///< -6.02 dB point of a first-order high-pass, 10...8000
  double level = 0.06;                        ///< linear, of everything, 0...10
};

/// Refuses nonsense, so that nothing can go wrong while the string plays. Throws std::invalid_argument with
/// `KEY: what is wrong, what was expected`. Thread: OFF, CT.
void require_valid(const StringModel& model);

/// One mode as physics has it and as the layer plays it.
struct StringMode {
  std::string_view family;  ///< "longitudinal" or "bending"
  int mode = 1;
  double target_hz = 0, model_hz = 0, error_cents = 0;
  double t60_s = 0;  ///< as the layer plays it, free
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

}  // namespace rigsound
