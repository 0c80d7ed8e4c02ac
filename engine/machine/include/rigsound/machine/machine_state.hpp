// What the machine is doing: the one type that crosses every wall.
#pragma once

#include <array>
#include <cstdint>

#include "rigsound/machine/limits.hpp"

namespace rigsound {

enum class Rattling : std::uint8_t { kNone, kClosed, kOpen };

/// Percussion as the bus reports it; `kFromFeed` when no bus does: on while the feed pressure is over
/// the contact threshold, or while rattling.
enum class Percussion : std::uint8_t { kOff, kOn, kFromFeed };

/// The six live controls of the drilling paper (section 4.4), per boom. All neutral by default.
struct DrillControls {
  float mean_frequency_hz = 0;    ///< 0: the machine's or the bank's own rate; else 1...100 Hz
  float mean_amplitude_db = 0;    ///< -60...+24 dB
  float deviation_time = 1;       ///< factor on sigma_T, 0...4
  float deviation_amplitude = 1;  ///< factor on sigma_B, 0...4
  float attack_factor = 1;        ///< factor on N_a, 0.1...10
  float decay_factor = 1;         ///< factor on alpha_d, 0.25...10
};

struct BoomState {
  float feed_pressure_bar = 0;  ///< bar, 0...300; 0: not feeding
  Rattling rattling = Rattling::kNone;
  Percussion percussion = Percussion::kFromFeed;
  float percussion_rate_hz = 0;  ///< Hz, 5...80; 0: the bank's own rate
  std::uint8_t rod_count = 1;    ///< 1...20
  std::uint16_t rock = 0;        ///< index of a rock named in the sound set
  DrillControls controls;
};

/// Plain data, field units, no pointers. Signals that were never seen keep the value that means "absent".
struct MachineState {
  float engine_rpm = 0;      ///< r/min, 0...4000; 0: diesel off
  float engine_load = -1;    ///< 0...1; negative: the scene derives it from feed and percussion
  float master_gain_db = 0;  ///< dB, -60...0
  float safety_gain = 1;     ///< 0...1, falls to 0 when a `mute` safety rule acts
  std::array<BoomState, kMaxBooms> boom{};
};

}  // namespace rigsound
