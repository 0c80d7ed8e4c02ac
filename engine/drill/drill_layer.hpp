// The clicks of one boom: every situation's bank on its own bus, crossfaded by the scene.
#pragma once

#include <array>
#include <cstdint>

#include "drill/click_player.hpp"
#include "impact/impact_train.hpp"
#include "scene/boom_scene.hpp"

namespace rigsound::drill {

class DrillLayer {
 public:
  DrillLayer(std::uint64_t seed, int boom);  ///< Thread: OFF

  /// The next kChunk samples. A bank whose slot is silent is not struck. Thread: RT.
  void process(const std::array<scene::Slot, kSituationCount>& slots, const DrillControls& controls,
               const impact::ImpactTrain& impacts, double* out) noexcept;

  std::uint64_t lost() const noexcept;

 private:
  std::array<ClickPlayer, kSituationCount> players_;
};

}  // namespace rigsound::drill
