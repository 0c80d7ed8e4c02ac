#include "scene/unrecorded_level.hpp"

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::scene {

UnrecordedLevel::UnrecordedLevel(const SoundSet& sounds, int string) {
  if (string < 0) return;
  const StringModel& model = sounds.strings[static_cast<std::size_t>(string)];
  const auto level = [&](const Rock& rock) { return 0.5 * dsp::log(energy_passes(model, rock.stiffness)); };
  per_joint_ = 0.5 * dsp::log(joint_transmission(model));
  usual_ = level(Rock{});
  for (const Rock& rock : sounds.rocks) rocks_.push_back(level(rock));
}

}  // namespace rigsound::scene
