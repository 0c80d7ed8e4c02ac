#include "scene/bank_choice.hpp"

namespace rigsound::scene {
namespace {

// One wrong rock weighs more than any difference in rods (at most 19).
constexpr int kAnyRock = 100, kWrongRock = 1000;

}  // namespace

int distance(const BankUse& use, int rods, int rock) noexcept {
  const int by_rock = use.rock == rock ? 0 : use.rock < 0 ? kAnyRock : kWrongRock;
  const int difference = use.rods > rods ? use.rods - rods : rods - use.rods;
  return by_rock + (use.rods == 0 ? 1 : difference);
}

const BankUse* choose_bank(const SoundSet& sounds, Situation situation, int rods, int rock) noexcept {
  const BankUse* best = nullptr;
  for (const BankUse& use : sounds.uses) {
    if (use.situation != situation) continue;
    if (!best || distance(use, rods, rock) < distance(*best, rods, rock)) best = &use;
  }
  return best;
}

}  // namespace rigsound::scene
