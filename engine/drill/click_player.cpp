#include "drill/click_player.hpp"

#include <algorithm>

namespace rigsound::drill {

ClickPlayer::ClickPlayer(std::uint64_t seed, int boom, int situation) noexcept
    : random_(seed, 2, static_cast<std::uint64_t>(boom * 16 + situation)) {}

const std::vector<float>& ClickPlayer::choose(const ClickBank& bank, std::uint64_t index) noexcept {
  const auto& clicks = bank.clicks;
  std::size_t barred = clicks.size();
  for (std::size_t i = 0; i < clicks.size(); ++i)
    if (&clicks[i] == last_ && clicks.size() > 1) barred = i;
  const std::size_t eligible = clicks.size() - (barred < clicks.size() ? 1 : 0);
  auto pick = static_cast<std::size_t>(random_.uniform(index, 0) * static_cast<double>(eligible));
  if (pick >= barred) ++pick;
  last_ = &clicks[pick];
  return clicks[pick];
}

void ClickPlayer::strike(const ClickBank& bank, const Impact& impact,
                         const DrillControls& controls) noexcept {
  const std::vector<float>& click = choose(bank, impact.index);
  const double gain = bank.B * impact.amplitude *
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
