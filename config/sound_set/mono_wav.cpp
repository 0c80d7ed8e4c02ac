#include "sound_set/mono_wav.hpp"

#include <cmath>
#include <string>

#include "rigsound/machine/input_error.hpp"
#include "sound_set/wav_sound.hpp"

namespace rigsound::config {

void write_mono_wav(const std::filesystem::path& file, const std::vector<float>& samples, int sample_rate) {
  write_samples(create_wav(file, sample_rate), file, samples.data(), samples.size());
}

MonoWav read_mono_wav(const std::filesystem::path& file) {
  const WavReader reader(file);
  MonoWav wav;
  wav.sample_rate = reader.format().samplerate;
  wav.samples.resize(static_cast<std::size_t>(reader.format().frames));
  reader.read(0, reader.format().frames, wav.samples.data());
  for (const float x : wav.samples)
    if (!std::isfinite(x)) throw InputError(file.string(), "holds samples that are not finite numbers");
  return wav;
}

}  // namespace rigsound::config
