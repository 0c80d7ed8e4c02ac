// A machine state as a row of 32-bit words, exact and in a fixed order.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::session {

#define RIGSOUND_ONE(...) +1  // NOLINT(bugprone-macro-parentheses): a term of a sum
constexpr int kWordsPerBoom =
    1 RIGSOUND_BOOM_SIGNALS(RIGSOUND_ONE) RIGSOUND_DRILL_CONTROLS(RIGSOUND_ONE);  // 1: by hand
constexpr int kStateWords =
    3 RIGSOUND_RIG_SIGNALS(RIGSOUND_ONE) + kMaxBooms * kWordsPerBoom;  // 3: slope, gain, by hand
#undef RIGSOUND_ONE
using StateWords = std::array<std::uint32_t, kStateWords>;

/// Which of the words: word i is bit i % 64 of mask i / 64.
using WordMasks = std::array<std::uint64_t, (kStateWords + 63) / 64>;
inline bool has(const WordMasks& masks, std::size_t i) { return (masks[i / 64] >> i % 64 & 1) != 0; }
inline void mark(WordMasks& masks, std::size_t i) { masks[i / 64] |= std::uint64_t{1} << i % 64; }

/// Thread: RT.
StateWords words_of(const MachineState& state) noexcept;
MachineState state_of(const StateWords& words) noexcept;

/// What no state can be: "boom 2: rattling: is 7, expected 0...2"; empty: nothing. Thread: OFF.
std::string problem_of(const StateWords& words);

}  // namespace rigsound::session
