// A sound file in memory, as libsndfile reads and writes one.
#pragma once

#include <sndfile.h>

#include <string>

namespace rigsound::audio {

struct SoundMemory {
  std::string bytes;  ///< of the file
  sf_count_t at = 0;  ///< where the next byte is read or written
};

/// For sf_open_virtual(), whose `user_data` is a SoundMemory. Thread: OFF.
SF_VIRTUAL_IO sound_memory_io() noexcept;

}  // namespace rigsound::audio
