// Sounds of the drill string, and what can be measured in them.
#pragma once

#include <functional>
#include <vector>

#include "rigsound/string_model.hpp"
#include "string/string_layer.hpp"

namespace rigsound::tests {

constexpr double kStringRate = 48000;

/// Without bounces and without chance.
StringModel plain_string(double length_m = 3.66, double diameter_m = 0.038, int rods = 1);

/// Neither shank nor sleeves, and next to no loss: a plain rod of `rods` lengths.
StringModel bare_string(double length_m, int rods);

struct StringBlows {
  double seconds = 1;
  double first_s = 0.00101, period_s = 0.025;
  double until_s = 1e9;  ///< no blow after that
};

/// The layer struck with even blows; `input(t)` is asked once a chunk.
std::vector<double> struck(string::StringLayer& layer, const StringBlows& blows,
                           const std::function<string::StringInput(double)>& input);

/// Waves at the shank of a string that a short pulse has hit, the bit in the air; `contact`: how hard the
/// guides hold it all the same.
std::vector<double> free_ringing(const StringModel& model, double seconds,
                                 dsp::LaneWidth width = dsp::widest_lanes(), double contact = 0);

/// Of the oscillation nearest `hz`, which nothing else in `sound` may come near: how far its phase gets
/// between two windows a third of the sound apart.
double frequency_near(const std::vector<double>& sound, double hz, double rate);

/// Sum of squares of samples from_s...to_s.
double energy_within(const std::vector<double>& sound, double from_s, double to_s);

/// Largest sample above 12.6 kHz within from_s...to_s against the largest of all: linear phase, 1601 taps
/// under a Kaiser window.
double residue_above_modes_db(const std::vector<double>& sound, double from_s, double to_s);

/// Mean of third-octave differences, dB; from 125 Hz to 10 kHz.
double third_octave_distance_db(const std::vector<double>& a, const std::vector<double>& b);

/// Frequencies of a free-free Timoshenko bar with Hutchinson's shear coefficient up to `highest_hz`, every
/// sign change of the characteristic function, none passed over.
std::vector<double> timoshenko_modes(double length_m, double diameter_m, double highest_hz);

/// The rod's bank struck every two seconds while its exposed length goes from `from_m` to `to_m` at
/// `speed_m_per_s`: largest residue above 12.6 kHz between the blows, dB.
double gliding_residue_db(const StringModel& model, double from_m, double to_m, double speed_m_per_s);

/// Largest relative growth from chunk to chunk of a string's energy, nothing striking it, while stiffness and
/// gap of its bit are drawn anew.
double largest_string_growth(const StringModel& model, int chunks, dsp::LaneWidth width);

/// The same of the bank while exposed length and contact are drawn anew.
double largest_bending_growth(const StringModel& model, int chunks, dsp::LaneWidth width);

/// Largest error of the share of energy that the bit sends back, x 0.25...3, against the closed form: pulses
/// of `samples` whole samples.
double largest_reflection_error(int samples);

/// Sum of squares of the 100 ms that begin 100 ms after the last of many blows.
double ringing_energy(const StringModel& model, const string::StringInput& input);

}  // namespace rigsound::tests
