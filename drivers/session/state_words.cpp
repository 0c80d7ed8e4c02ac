#include "session/state_words.hpp"

#include <cmath>
#include <cstring>

#include "rigsound/machine/signal.hpp"

namespace rigsound::session {
namespace {

std::uint32_t word_of(float value) noexcept {
  std::uint32_t word = 0;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

template <typename Small>
std::uint32_t word_of(Small value) noexcept {
  return static_cast<std::uint32_t>(value);
}

void read_word(std::uint32_t word, float& value) noexcept { std::memcpy(&value, &word, sizeof word); }

template <typename Small>
void read_word(std::uint32_t word, Small& value) noexcept {
  value = static_cast<Small>(word);
}

bool is_finite(float value) noexcept { return std::isfinite(value); }
template <typename Small>
bool is_finite(Small) noexcept {
  return true;
}

}  // namespace

StateWords words_of(const MachineState& state) noexcept {
  StateWords words{};
  std::size_t i = 0;
  for_each_field(state, [&](const auto& field) { words[i++] = word_of(field); });
  return words;
}

MachineState state_of(const StateWords& words) noexcept {
  MachineState state;
  std::size_t i = 0;
  for_each_field(state, [&](auto& field) { read_word(words[i++], field); });
  return state;
}

std::string problem_of(const StateWords& words) {
  const MachineState state = state_of(words);
  std::string problem;
  for_each_signal(kMaxBooms, [&](SignalId id) {
    const SignalInfo& signal = info(id.signal);
    const double value = signal.get(state, id.boom);
    if (!problem.empty() || !signal.stepped() || signal.takes(value) || value == signal.absent) return;
    problem = (signal.per_boom ? "boom " + std::to_string(id.boom + 1) + ": " : "") +
              std::string(signal.name) + ": " + signal.range().problem(value);
  });
  if (!problem.empty()) return problem;
  bool finite = true;
  for_each_field(state, [&](const auto& field) { finite = finite && is_finite(field); });
  if (!finite) return "holds a number that is not finite, expected numbers";
  return words_of(state) == words ? "" : "holds a word too large for its field, expected a smaller one";
}

}  // namespace rigsound::session
