#include "audio/sound_bytes.hpp"

#include <sndfile.h>

#include <memory>
#include <stdexcept>

#include "rigsound/analysis/wave_file.hpp"
#include "rigsound/audio/sound_memory.hpp"

namespace rigsound::analysis {
namespace {

std::string bytes_of(const std::vector<float>& mono, int rate, int format, const char* name) {
  audio::SoundMemory memory;
  SF_VIRTUAL_IO io = audio::sound_memory_io();
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
