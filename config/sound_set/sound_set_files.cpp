#include "rigsound/config/sound_set_files.hpp"

#include "rigsound/config/packed_set.hpp"

namespace rigsound::config {

SoundSetParts load_sound_set(const std::filesystem::path& sound_set) {
  std::error_code error;
  return std::filesystem::is_regular_file(sound_set, error) ? load_packed(sound_set).parts
                                                            : load_parts(sound_set);
}

}  // namespace rigsound::config
