#include "drill/drill_layer.hpp"

#include <algorithm>

namespace rigsound::drill {

DrillLayer::DrillLayer(std::uint64_t seed, int boom)
    : players_{ClickPlayer(seed, boom, 0), ClickPlayer(seed, boom, 1), ClickPlayer(seed, boom, 2),
               ClickPlayer(seed, boom, 3), ClickPlayer(seed, boom, 4)} {
  static_assert(kSituationCount == 5, "one player a situation");
}

void DrillLayer::process(const DrillInput& input, const Impacts& impacts, double* out) noexcept {
  std::fill(out, out + kChunk, 0.0);
  for (std::size_t s = 0; s < input.slots.size(); ++s) {
    const Slot& slot = input.slots[s];
    if (slot.bank && slot.gain.to > 0)
      for (const Impact& impact : impacts) players_[s].strike(*slot.bank, impact, input.controls);
    double bus[kChunk] = {};
    if (players_[s].add_to(bus)) dsp::add_scaled(slot.gain, bus, out, kChunk);
  }
}

std::uint64_t DrillLayer::lost() const noexcept {
  std::uint64_t lost = 0;
  for (const ClickPlayer& player : players_) lost += player.lost();
  return lost;
}

}  // namespace rigsound::drill
