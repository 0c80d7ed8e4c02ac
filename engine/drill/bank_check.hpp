// What a bank must be before anything may play it.
#pragma once

#include "rigsound/click_bank.hpp"

namespace rigsound::drill {

/// Throws std::invalid_argument naming the bank and the field when `bank` cannot be played: no clicks,
/// an empty or non-finite click, a period or amplitude that is not positive, a correlation or share out
/// of range. Thread: OFF.
void require_playable(const ClickBank& bank);

}  // namespace rigsound::drill
