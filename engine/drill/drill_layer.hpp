// The clicks of one boom: each voicing's banks on a bus of their own, crossfaded by the scene.
#pragma once

#include <array>
#include <cstdint>

#include "drill/click_player.hpp"
#include "drill/drill_input.hpp"
#include "drill/tilt_filter.hpp"

namespace rigsound::drill {

class DrillLayer {
 public:
  DrillLayer(std::uint64_t seed, int boom, double sample_rate);  ///< Thread: OFF

  /// The next kChunk samples; false: all of them are zero. A bank whose slot is silent is not struck. Thread:
  /// RT.
  bool process(const DrillInput& input, const Impacts& impacts, double* out) noexcept;

  void reset() noexcept;  ///< to silence. Thread: RT

  std::uint64_t lost() const noexcept;

 private:
  void add_voicing(int v, const Slot& slot, double* out) noexcept;

  std::array<ClickPlayer, kVoicings> players_;
  std::array<TiltFilter, kVoicings> tilts_;
  bool rests_ = true;  ///< nothing sounds until the next impact
};

}  // namespace rigsound::drill
