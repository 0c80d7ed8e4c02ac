// The machine's signals and the drill's live controls: the one list. Everything that names, checks, fades,
// stores, shows or documents a signal visits it; a new signal is one line here and the scene rule that uses
// it.
#pragma once

/// One line a signal: SIGNAL(id, member, type, unit, min, max, absent, idle, safety action, kind, words,
/// meaning). `absent` stands while the signal was never seen, `idle` means quiet (safety rule `idle`).
/// `words`: names of the values 0, 1, ... separated by `|`. The order is the order of a session's words: a
/// change raises kSessionFormat.
// clang-format off
#define RIGSOUND_RIG_SIGNALS(SIGNAL) \
  SIGNAL(kEngineRpm, engine_rpm, float, "r/min", 0, 4000, 0, 0, kIdle, kClampedNumber, "", \
         "diesel speed; 0: off") \
  SIGNAL(kEngineLoad, engine_load, float, "", 0, 1, -1, 0, kHold, kNumber, "", \
         "diesel load; absent: from feed and percussion") \
  SIGNAL(kMasterGainDb, master_gain_db, float, "dB", -60, 0, 0, -60, kHold, kNumber, "", \
         "level of everything") \
  SIGNAL(kSimulation, simulation, Simulation, "", 0, 2, 0, 0, kHold, kWord, "run|freeze|reset", \
         "simulator running, paused, back at its start")

#define RIGSOUND_BOOM_SIGNALS(SIGNAL) \
  SIGNAL(kFeedPressureBar, feed_pressure_bar, float, "bar", 0, 300, 0, 0, kIdle, kClampedNumber, "", \
         "feed; 0: not feeding") \
  SIGNAL(kRattling, rattling, Rattling, "", 0, 2, 0, 0, kIdle, kWord, "none|closed|open", \
         "rattling mode") \
  SIGNAL(kPercussion, percussion, Percussion, "", 0, 1, 2, 0, kIdle, kWord, "off|on", \
         "hammer; absent: on while in contact or rattling") \
  SIGNAL(kPercussionRateHz, percussion_rate_hz, float, "Hz", 5, 120, 0, 0, kHold, kNumberOrZero, "", \
         "impacts a second; 0: the bank's own") \
  SIGNAL(kRodCount, rod_count, std::uint8_t, "", 1, 20, 1, 1, kHold, kWhole, "", \
         "rods on the string") \
  SIGNAL(kRock, rock, std::uint16_t, "", 0, 65535, 0, 0, kHold, kWhole, "", \
         "a rock of the sound set") \
  SIGNAL(kPercussionPressureBar, percussion_pressure_bar, float, "bar", 0, 300, -1, 0, kHold, kClampedNumber, "", \
         "hammer pressure") \
  SIGNAL(kRotationPressureBar, rotation_pressure_bar, float, "bar", 0, 300, -1, 0, kHold, kClampedNumber, "", \
         "rotation pressure") \
  SIGNAL(kDamperPressureBar, damper_pressure_bar, float, "bar", 0, 200, -1, 0, kHold, kClampedNumber, "", \
         "damper pressure") \
  SIGNAL(kFlushing, flushing, float, "", 0, 1, -1, 0, kHold, kNumber, "", \
         "flushing flow") \
  SIGNAL(kFeedPositionM, feed_position_m, float, "m", 0, 8, -1, 0, kHold, kNumber, "", \
         "current rod in the hole") \
  SIGNAL(kRodBroken, rod_broken, RodBroken, "", 0, 1, 0, 0, kHold, kWord, "no|yes", \
         "a rod has broken")

/// The six live controls of the drilling paper (section 4.4), per boom:
/// CONTROL(member, unit, min, max, neutral, kind, meaning).
#define RIGSOUND_DRILL_CONTROLS(CONTROL) \
  CONTROL(mean_frequency_hz, "Hz", 1, 120, 0, kNumberOrZero, "impacts a second; 0: the machine's or the bank's own") \
  CONTROL(mean_amplitude_db, "dB", -60, 24, 0, kNumber, "level of the clicks") \
  CONTROL(deviation_time, "", 0, 4, 1, kNumber, "factor on the scatter of the gaps, sigma_T") \
  CONTROL(deviation_amplitude, "", 0, 4, 1, kNumber, "factor on the scatter of the amplitudes, sigma_B") \
  CONTROL(attack_factor, "", 0.1, 10, 1, kNumber, "factor on the attack, N_a") \
  CONTROL(decay_factor, "", 0.25, 10, 1, kNumber, "factor on the decay, alpha_d")
// clang-format on
