#include "session/state_words.hpp"

#include <cstring>

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

}  // namespace rigsound::session
