#include "rigsound/config/rig.hpp"
#include "rigsound/config/sound_set_files.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {

SoundSet load_sounds(Rig& rig) {
  if (rig.sound_set.empty())
    throw InputError(rig.file.string(), rig.sound_set_line, "sound.set",
                     "is missing, expected the folder of a sound set");
  std::error_code error;
  if (!std::filesystem::exists(rig.sound_set, error))
    throw InputError(rig.file.string(), rig.sound_set_line, "sound.set",
                     "there is no folder " + rig.sound_set.string() + ", expected a sound set");
  return sounds_of(rig, load_sound_set(rig.sound_set));
}

}  // namespace rigsound::config
