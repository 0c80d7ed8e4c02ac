#include "sound_set/wav_sound.hpp"

#include <cstdint>
#include <fstream>
#include <string>

#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace {

/// libsndfile reads what there is of a file that was cut off and says nothing.
void require_whole(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  unsigned char head[8] = {};
  in.read(reinterpret_cast<char*>(head), sizeof head);
  if (!in || std::string(head, head + 4) != "RIFF") return;
  const std::uint64_t announced =
      8 + (head[4] | head[5] << 8 | head[6] << 16 | static_cast<std::uint64_t>(head[7]) << 24);
  std::error_code error;
  const std::uint64_t there = std::filesystem::file_size(file, error);
  if (there < announced)
    throw InputError(file.string(), "is cut off after " + std::to_string(there) + " bytes, expected " +
                                        std::to_string(announced));
}

}  // namespace

WavSound create_wav(const std::filesystem::path& file, int sample_rate) {
  SF_INFO format{};
  format.samplerate = sample_rate;
  format.channels = 1;
  format.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  WavSound sound(sf_open(file.c_str(), SFM_WRITE, &format), sf_close);
  if (!sound) throw DeviceError(file.string() + ": cannot be written: " + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  return sound;
}

WavSound open_wav(const std::filesystem::path& file, SF_INFO& format) {
  WavSound sound(sf_open(file.c_str(), SFM_READ, &format), sf_close);
  if (!sound)
    throw InputError(file.string(),
                     std::string("cannot be read, expected a WAV file: ") + sf_strerror(nullptr));
  require_whole(file);
  if (format.channels != 1)
    throw InputError(file.string(), std::to_string(format.channels) + " channels, expected 1");
  return sound;
}

void write_samples(const WavSound& sound, const std::filesystem::path& file, const float* samples,
                   std::size_t count) {
  const auto wanted = static_cast<sf_count_t>(count);
  if (sf_write_float(sound.get(), samples, wanted) != wanted)
    throw DeviceError(file.string() + ": cannot be written whole: " + sf_strerror(sound.get()));
}

}  // namespace rigsound::config
