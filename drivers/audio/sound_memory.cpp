#include "rigsound/audio/sound_memory.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace rigsound::audio {
namespace {

SoundMemory& memory_of(void* user) { return *static_cast<SoundMemory*>(user); }

sf_count_t memory_length(void* user) { return static_cast<sf_count_t>(memory_of(user).bytes.size()); }

sf_count_t memory_seek(sf_count_t offset, int whence, void* user) {
  SoundMemory& memory = memory_of(user);
  const sf_count_t from = whence == SEEK_CUR ? memory.at : whence == SEEK_END ? memory_length(user) : 0;
  return memory.at = std::max<sf_count_t>(0, from + offset);
}

sf_count_t memory_read(void* to, sf_count_t count, void* user) {
  SoundMemory& memory = memory_of(user);
  const sf_count_t left = std::max<sf_count_t>(0, memory_length(user) - memory.at);
  count = std::clamp<sf_count_t>(count, 0, left);
  if (count > 0) std::memcpy(to, memory.bytes.data() + memory.at, static_cast<std::size_t>(count));
  memory.at += count;
  return count;
}

sf_count_t memory_write(const void* from, sf_count_t count, void* user) {
  SoundMemory& memory = memory_of(user);
  memory.bytes.resize(static_cast<std::size_t>(std::max(memory_length(user), memory.at + count)));
  std::memcpy(memory.bytes.data() + memory.at, from, static_cast<std::size_t>(count));
  memory.at += count;
  return count;
}

sf_count_t memory_tell(void* user) { return memory_of(user).at; }

}  // namespace

SF_VIRTUAL_IO sound_memory_io() noexcept {
  return {memory_length, memory_seek, memory_read, memory_write, memory_tell};
}

}  // namespace rigsound::audio
