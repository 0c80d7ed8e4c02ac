// A machine state as a row of 32-bit words, exact and in a fixed order.
#pragma once

#include <array>
#include <cstdint>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::log {

constexpr int kWordsPerBoom = 12;
constexpr int kStateWords = 4 + kMaxBooms * kWordsPerBoom;
using StateWords = std::array<std::uint32_t, kStateWords>;

/// Thread: RT.
StateWords words_of(const MachineState& state) noexcept;
MachineState state_of(const StateWords& words) noexcept;

}  // namespace rigsound::log
