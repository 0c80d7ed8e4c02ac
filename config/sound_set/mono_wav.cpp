#include "sound_set/mono_wav.hpp"

#include <sndfile.h>

#include <cmath>
#include <memory>
#include <string>

#include "rigsound/device_error.hpp"
#include "rigsound/input_error.hpp"

namespace rigsound::config {
namespace {

using Sound = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

}  // namespace

void write_mono_wav(const std::filesystem::path& file, const std::vector<float>& samples, int sample_rate) {
  SF_INFO format{};
  format.samplerate = sample_rate;
  format.channels = 1;
  format.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  const Sound sound(sf_open(file.c_str(), SFM_WRITE, &format), sf_close);
  if (!sound) throw DeviceError(file.string() + ": cannot be written: " + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  const auto count = static_cast<sf_count_t>(samples.size());
  if (sf_write_float(sound.get(), samples.data(), count) != count)
    throw DeviceError(file.string() + ": cannot be written whole: " + sf_strerror(sound.get()));
}

MonoWav read_mono_wav(const std::filesystem::path& file) {
  SF_INFO format{};
  const Sound sound(sf_open(file.c_str(), SFM_READ, &format), sf_close);
  if (!sound)
    throw InputError(file.string(), std::string("cannot be read as a WAV file: ") + sf_strerror(nullptr));
  if (format.channels != 1)
    throw InputError(file.string(), std::to_string(format.channels) + " channels, expected 1");
  MonoWav wav;
  wav.sample_rate = format.samplerate;
  wav.samples.resize(static_cast<std::size_t>(format.frames));
  if (sf_read_float(sound.get(), wav.samples.data(), format.frames) != format.frames)
    throw InputError(file.string(), "ends early, expected " + std::to_string(format.frames) + " samples");
  for (const float x : wav.samples)
    if (!std::isfinite(x)) throw InputError(file.string(), "holds samples that are not finite numbers");
  return wav;
}

}  // namespace rigsound::config
