#include "drill/drill_layer.hpp"

#include <algorithm>

namespace rigsound::drill {

DrillLayer::DrillLayer(std::uint64_t seed, int boom, double sample_rate)
    : players_{ClickPlayer(seed, boom, 0), ClickPlayer(seed, boom, 1), ClickPlayer(seed, boom, 2)},
      tilts_{TiltFilter(sample_rate), TiltFilter(sample_rate), TiltFilter(sample_rate)} {
  static_assert(kVoicings == 3, "one player a voicing");
}

bool DrillLayer::process(const DrillInput& input, const Impacts& impacts, double* out) noexcept {
  std::fill(out, out + kChunk, 0.0);
  if (rests_ && impacts.count == 0) return false;
  bool sounds = false;
  for (int v = 0; v < kVoicings; ++v) {
    const Slot& slot = input.slots[v];
    if (slot.banks.count > 0 && slot.gain.to > 0)
      for (const Impact& impact : impacts) players_[v].strike(slot.banks, impact, slot.controls);
    if (!players_[v].sounds() && tilts_[v].rests()) continue;
    const bool plain = slot.gain.rests_at(1) && slot.tilt_db_per_octave == 0 && tilts_[v].rests();
    if (plain && !sounds)
      players_[v].add_to(out);
    else
      add_voicing(v, slot, out);
    sounds = true;
  }
  rests_ = !sounds;
  return sounds;
}

void DrillLayer::add_voicing(int v, const Slot& slot, double* out) noexcept {
  double bus[kChunk] = {};
  players_[v].add_to(bus);
  tilts_[v].process(slot.tilt_db_per_octave, bus);
  dsp::add_scaled(slot.gain, bus, out, kChunk);
}

void DrillLayer::reset() noexcept {
  rests_ = true;
  for (ClickPlayer& player : players_) player.reset();
  for (TiltFilter& tilt : tilts_) tilt.reset();
}

std::uint64_t DrillLayer::lost() const noexcept {
  std::uint64_t lost = 0;
  for (const ClickPlayer& player : players_) lost += player.lost();
  return lost;
}

}  // namespace rigsound::drill
