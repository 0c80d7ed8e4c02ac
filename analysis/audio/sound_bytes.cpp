#include "audio/sound_bytes.hpp"

#include <sndfile.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "rigsound/analysis/wave_file.hpp"

namespace rigsound::analysis {
namespace {

/// What libsndfile writes to and goes back in.
struct Memory {
  std::string bytes;
  sf_count_t at = 0;
};

sf_count_t length(void* user) { return static_cast<sf_count_t>(static_cast<Memory*>(user)->bytes.size()); }

sf_count_t seek(sf_count_t offset, int whence, void* user) {
  auto& memory = *static_cast<Memory*>(user);
  return memory.at = offset + (whence == SEEK_CUR ? memory.at : whence == SEEK_END ? length(user) : 0);
}

sf_count_t read(void* to, sf_count_t count, void* user) {
  auto& memory = *static_cast<Memory*>(user);
  count = std::clamp<sf_count_t>(length(user) - memory.at, 0, count);
  std::memcpy(to, memory.bytes.data() + memory.at, static_cast<std::size_t>(count));
  memory.at += count;
  return count;
}

sf_count_t write(const void* from, sf_count_t count, void* user) {
  auto& memory = *static_cast<Memory*>(user);
  memory.bytes.resize(static_cast<std::size_t>(std::max(length(user), memory.at + count)));
  std::memcpy(memory.bytes.data() + memory.at, from, static_cast<std::size_t>(count));
  memory.at += count;
  return count;
}

sf_count_t tell(void* user) { return static_cast<Memory*>(user)->at; }

std::string bytes_of(const std::vector<float>& mono, int rate, int format, const char* name) {
  Memory memory;
  SF_VIRTUAL_IO io{length, seek, read, write, tell};
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = 1;
  info.format = format;
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound(sf_open_virtual(&io, SFM_WRITE, &info, &memory),
                                                    sf_close);
  const std::string problem = std::string("a sound cannot be packed as ") + name;
  if (!sound) throw std::runtime_error(problem + ": " + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
  const auto frames = static_cast<sf_count_t>(mono.size());
  if (sf_writef_float(sound.get(), mono.data(), frames) != frames) throw std::runtime_error(problem);
  sound.reset();  // writes what is left
  return memory.bytes;
}

}  // namespace

std::string flac_bytes(const std::vector<float>& mono, int rate) {
  return bytes_of(mono, rate, SF_FORMAT_FLAC | SF_FORMAT_PCM_16, "FLAC");
}

std::string wave_bytes(const std::vector<float>& mono, int rate) {
  return bytes_of(mono, rate, SF_FORMAT_WAV | SF_FORMAT_FLOAT, "WAV");
}

}  // namespace rigsound::analysis
