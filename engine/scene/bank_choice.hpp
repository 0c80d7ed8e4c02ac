// Which bank of the sound set fits a situation, a rod count and a rock best.
#pragma once

#include "rigsound/sound_set.hpp"

namespace rigsound::scene {

/// How far a use is from what is asked for: rods apart, an any-rock use after every exact one, another rock
/// last. Thread: any.
int distance(const BankUse& use, int rods, int rock) noexcept;

/// The use of `situation` whose rock matches (a use for any rock comes second, another rock last) and
/// whose rod count is nearest (a use for any count ranks as one rod away). Null when the set has none.
/// Thread: RT.
const BankUse* choose_bank(const SoundSet& sounds, Situation situation, int rods, int rock) noexcept;

}  // namespace rigsound::scene
