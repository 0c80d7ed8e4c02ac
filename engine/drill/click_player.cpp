#include "drill/click_player.hpp"

#include <algorithm>

namespace rigsound::drill {

ClickPlayer::ClickPlayer(std::uint64_t seed, int boom, int situation) noexcept
    : random_(seed, 2, static_cast<std::uint64_t>(boom * 16 + situation)) {}

const std::vector<float>& ClickPlayer::choose(const ClickBank& bank, std::uint64_t index) noexcept {
  if (bank_ != &bank) bank_ = &bank, resting_count_ = 0;
  const auto resting_up_to = [this](std::size_t click) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < resting_count_; ++i) count += resting_[i] <= click ? 1 : 0;
    return count;
  };
  const auto rested = static_cast<double>(bank.clicks.size() - resting_count_);
  const auto rank = static_cast<std::size_t>(random_.uniform(index, 0) * rested);
  std::size_t pick = rank;  // of all clicks, where `rank` counts the rested ones only
  while (pick < rank + resting_up_to(pick)) pick = rank + resting_up_to(pick);
  rest(pick, bank.clicks.size());
  return bank.clicks[pick];
}

void ClickPlayer::rest(std::size_t click, std::size_t clicks) noexcept {
  const std::size_t most = std::min(clicks / 2, kMaxResting);
  if (most == 0) return;
  if (resting_count_ == most) {
    for (std::size_t i = 1; i < most; ++i) resting_[i - 1] = resting_[i];
    --resting_count_;
  }
  resting_[resting_count_++] = click;
}

void ClickPlayer::strike(const ClickBank& bank, const Impact& impact,
                         const DrillControls& controls) noexcept {
  const std::vector<float>& click = choose(bank, impact.index);
  const double gain = bank.mean_amplitude * impact.amplitude *
                      dsp::gain_of_db(bank.gain_db + static_cast<double>(controls.mean_amplitude_db));
  const int delay = static_cast<int>(std::floor(impact.onset + 0.5));
  for (ClickVoice& voice : voices_) {
    if (voice.sounding()) continue;
    voice.start(bank, click, delay, gain, controls);
    return;
  }
  ++lost_;
}

bool ClickPlayer::add_to(double* bus) noexcept {
  bool any = false;
  for (ClickVoice& voice : voices_) {
    if (!voice.sounding()) continue;
    voice.add_to(bus);
    any = true;
  }
  return any;
}

}  // namespace rigsound::drill
