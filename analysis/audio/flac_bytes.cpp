#include "audio/flac_bytes.hpp"

#include <sndfile.h>

#include <memory>
#include <stdexcept>

#include "rigsound/audio/sound_memory.hpp"

namespace rigsound::analysis {
std::string flac_bytes(const std::vector<float>& mono, int rate) {
  audio::SoundMemory memory;
  SF_VIRTUAL_IO io = audio::sound_memory_io();
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = 1;
  info.format = SF_FORMAT_FLAC | SF_FORMAT_PCM_16;
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound(sf_open_virtual(&io, SFM_WRITE, &info, &memory),
                                                    sf_close);
  if (!sound)
    throw std::runtime_error(std::string("a sound cannot be packed as FLAC: ") + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
  const auto frames = static_cast<sf_count_t>(mono.size());
  if (sf_writef_float(sound.get(), mono.data(), frames) != frames)
    throw std::runtime_error("a sound cannot be packed as FLAC");
  sound.reset();  // writes what is left
  return memory.bytes;
}

}  // namespace rigsound::analysis
