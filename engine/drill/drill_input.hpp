// What the clicks of one boom follow.
#pragma once

#include <array>

#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/machine/machine_state.hpp"

namespace rigsound::drill {

constexpr int kMaxChoices = 4;  ///< two rod counts, two feeds

/// The banks an impact may draw its click from. Shares add up to 1; none: silence.
struct BankChoices {
  BankChoices() = default;
  BankChoices(const ClickBank& only) noexcept { add(only, 1); }

  struct Choice {
    const ClickBank* bank;
    double share;
  };
  std::array<Choice, kMaxChoices> choice{};
  int count = 0;

  /// Returns where it stands in `choice`; -1: nowhere, its share is 0 or every place is taken.
  int add(const ClickBank& bank, double share) noexcept;
  /// The bank that a number drawn evenly from 0...1 falls on. Not to be asked of none.
  const ClickBank& drawn(double uniform) const noexcept;
};

/// How far the sound has gone on beyond the outermost recorded bank.
struct Trend {
  double ln_gap = 0, ln_level = 0, ln_decay = 0;
  double gap_variation = 0, amplitude_variation = 0;  ///< added
  double tilt_db_per_octave = 0;
};

enum class Voicing : int { kDrilling, kClosedRattling, kOpenRattling };
constexpr int kVoicings = 3;

/// The banks that serve a voicing now, how much duller or brighter than recorded, and its level over the
/// chunk, linear.
struct Slot {
  BankChoices banks;
  DrillControls controls;
  double tilt_db_per_octave = 0;
  dsp::Ramp gain{0, 0};
};

struct DrillInput {
  std::array<Slot, kVoicings> slots{};
};

}  // namespace rigsound::drill
