#include "drill/click_player.hpp"

#include <algorithm>

namespace rigsound::drill {

ClickPlayer::ClickPlayer(std::uint64_t seed, int boom, int voicing) noexcept
    : random_(seed, 2, static_cast<std::uint64_t>(boom * 16 + voicing)) {}

void ClickPlayer::Rest::add(std::size_t played) noexcept {
  const std::size_t most = std::min(bank->clicks.size() / 2, kMaxResting);
  if (most == 0) return;
  if (count == most) {
    for (std::size_t i = 1; i < most; ++i) click[i - 1] = click[i];
    --count;
  }
  click[count++] = played;
}

std::size_t ClickPlayer::Rest::up_to(std::size_t played) const noexcept {
  std::size_t resting = 0;
  for (std::size_t i = 0; i < count; ++i) resting += click[i] <= played ? 1 : 0;
  return resting;
}

ClickPlayer::Rest& ClickPlayer::rest_of(const ClickBank& bank) noexcept {
  for (Rest& rest : rests_)
    if (rest.bank == &bank) return rest;
  Rest& rest = rests_[next_rest_];
  next_rest_ = (next_rest_ + 1) % rests_.size();
  rest = Rest{&bank};
  return rest;
}

const Click& ClickPlayer::choose(const ClickBank& bank, std::uint64_t index) noexcept {
  Rest& rest = rest_of(bank);
  const auto rested = static_cast<double>(bank.clicks.size() - rest.count);
  const auto rank = static_cast<std::size_t>(random_.uniform(index, 0) * rested);
  std::size_t pick = rank;  // of all clicks, where `rank` counts the rested ones only
  while (pick < rank + rest.up_to(pick)) pick = rank + rest.up_to(pick);
  rest.add(pick);
  return bank.clicks[pick];
}

void ClickPlayer::strike(const BankChoices& banks, const Impact& impact,
                         const DrillControls& controls) noexcept {
  const ClickBank& bank = banks.drawn(random_.uniform(impact.index, 1));
  const Click& click = choose(bank, impact.index);
  const double gain = bank.mean_amplitude * impact.amplitude *
                      dsp::gain_of_db(bank.gain_db + static_cast<double>(controls.mean_amplitude_db));
  const int delay = static_cast<int>(std::floor(impact.onset + 0.5));
  const std::uint64_t free = ~sounding_;
  if (free == 0) {
    ++lost_;
    return;
  }
  voices_[static_cast<std::size_t>(__builtin_ctzll(free))].start(bank, click, delay, gain, controls);
  sounding_ |= free & (~free + 1);
}

void ClickPlayer::add_to(double* bus) noexcept {
  for (std::uint64_t left = sounding_; left != 0; left &= left - 1) {
    ClickVoice& voice = voices_[static_cast<std::size_t>(__builtin_ctzll(left))];
    voice.add_to(bus);
    if (!voice.sounding()) sounding_ &= ~(left & (~left + 1));
  }
}

}  // namespace rigsound::drill
