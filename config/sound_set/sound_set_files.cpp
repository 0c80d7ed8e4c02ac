#include "rigsound/config/sound_set_files.hpp"

#include "rigsound/config/packed_set.hpp"

namespace rigsound::config {

SoundSetParts load_sound_set(const std::filesystem::path& sound_set) {
  std::error_code error;
  return std::filesystem::is_regular_file(sound_set, error) ? load_packed(sound_set).parts
                                                            : load_parts(sound_set);
}

std::vector<std::filesystem::path> content_of(const std::filesystem::path& sound_set) {
  std::error_code error;
  if (sound_set.empty()) return {};
  if (std::filesystem::is_regular_file(sound_set, error)) return {sound_set};
  return {sound_set / "soundset.toml", sound_set / "banks", sound_set / "tools", sound_set / "backgrounds"};
}

}  // namespace rigsound::config
