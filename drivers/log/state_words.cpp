#include "log/state_words.hpp"

#include <cstring>

namespace rigsound::log {
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

// The one list of fields. The order is the file format: only ever append, and raise kSessionFormat.
template <typename State, typename Visit>
void for_each_field(State& s, Visit visit) noexcept {
  visit(s.engine_rpm), visit(s.engine_load), visit(s.master_gain_db), visit(s.safety_gain);
  for (auto& b : s.boom) {
    visit(b.feed_pressure_bar), visit(b.rattling), visit(b.percussion), visit(b.percussion_rate_hz);
    visit(b.rod_count), visit(b.rock);
    auto& c = b.controls;
    visit(c.mean_frequency_hz), visit(c.mean_amplitude_db), visit(c.deviation_time);
    visit(c.deviation_amplitude), visit(c.attack_factor), visit(c.decay_factor);
  }
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

}  // namespace rigsound::log
