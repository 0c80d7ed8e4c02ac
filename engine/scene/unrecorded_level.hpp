// How loud drilling is with rods and on rock that nobody recorded, by the physics of the drill string.
#pragma once

#include <vector>

#include "rigsound/sound_set.hpp"

namespace rigsound::scene {

/// Natural logarithms of amplitude.
class UnrecordedLevel {
 public:
  /// Of SoundSet::strings[string]; without one (-1) nothing changes. Thread: OFF.
  UnrecordedLevel(const SoundSet& sounds, int string);

  /// With so many joints more than recorded: each takes its share of a blow. Thread: RT.
  double of_joints(double more) const noexcept { return per_joint_ * more; }

  /// On `rock` with a bank of `recorded` rock: the more a rock sends back, the longer a blow rings in the
  /// string. Indices into SoundSet::rocks; any other: a rock of usual stiffness. Thread: RT.
  double of_rock(int rock, int recorded) const noexcept { return on(rock) - on(recorded); }

 private:
  double on(int rock) const noexcept {
    return rock >= 0 && rock < static_cast<int>(rocks_.size()) ? rocks_[static_cast<std::size_t>(rock)]
                                                               : usual_;
  }

  double per_joint_ = 0, usual_ = 0;
  std::vector<double> rocks_;
};

}  // namespace rigsound::scene
