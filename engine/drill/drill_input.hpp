// What the clicks of one boom follow.
#pragma once

#include <array>

#include "rigsound/click_bank.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/machine/machine_state.hpp"
#include "rigsound/machine/situation.hpp"

namespace rigsound::drill {

/// The bank that serves a situation now, and its gain over the chunk, linear.
struct Slot {
  const ClickBank* bank = nullptr;
  dsp::Ramp gain{0, 0};
};

struct DrillInput {
  std::array<Slot, kSituationCount> slots{};
  DrillControls controls;
};

}  // namespace rigsound::drill
