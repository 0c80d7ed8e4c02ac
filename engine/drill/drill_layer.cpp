#include "drill/drill_layer.hpp"

#include <algorithm>

namespace rigsound::drill {

DrillLayer::DrillLayer(std::uint64_t seed, int boom)
    : players_{ClickPlayer(seed, boom, 0), ClickPlayer(seed, boom, 1), ClickPlayer(seed, boom, 2),
               ClickPlayer(seed, boom, 3), ClickPlayer(seed, boom, 4)} {
  static_assert(kSituationCount == 5, "one player a situation");
}

void DrillLayer::process(const std::array<scene::Slot, kSituationCount>& slots, const DrillControls& controls,
                         const impact::ImpactTrain& impacts, double* out) noexcept {
  std::fill(out, out + kChunk, 0.0);
  for (std::size_t s = 0; s < slots.size(); ++s) {
    const scene::Slot& slot = slots[s];
    if (slot.bank && slot.gain_to > 0)
      for (int i = 0; i < impacts.count(); ++i) players_[s].strike(*slot.bank, impacts.begin()[i], controls);
    double bus[kChunk] = {};
    if (!players_[s].add_to(bus)) continue;
    const double step = (slot.gain_to - slot.gain_from) / kChunk;
    for (int n = 0; n < kChunk; ++n) out[n] += (slot.gain_from + step * (n + 1)) * bus[n];
  }
}

std::uint64_t DrillLayer::lost() const noexcept {
  std::uint64_t lost = 0;
  for (const ClickPlayer& player : players_) lost += player.lost();
  return lost;
}

}  // namespace rigsound::drill
