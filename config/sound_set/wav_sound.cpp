#include "sound_set/wav_sound.hpp"

#include <cstdint>
#include <string>

#include "rigsound/device_error.hpp"
#include "rigsound/file/input_file.hpp"
#include "rigsound/machine/input_error.hpp"

namespace rigsound::config {
namespace {

/// libsndfile reads what there is of a file that was cut off and says nothing.
void require_whole(const std::string& bytes, const std::string& name) {
  if (bytes.size() < 8 || bytes.compare(0, 4, "RIFF") != 0) return;
  const auto size = [&](std::size_t i) {
    return static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[4 + i])) << 8 * i;
  };
  const std::uint64_t announced = 8 + (size(0) | size(1) | size(2) | size(3));
  if (bytes.size() < announced)
    throw InputError(name, "is cut off after " + std::to_string(bytes.size()) + " bytes, expected " +
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

void write_samples(const WavSound& sound, const std::filesystem::path& file, const float* samples,
                   std::size_t count) {
  const auto wanted = static_cast<sf_count_t>(count);
  if (sf_write_float(sound.get(), samples, wanted) != wanted)
    throw DeviceError(file.string() + ": cannot be written whole: " + sf_strerror(sound.get()));
}

WavReader::WavReader(const std::filesystem::path& file)
    : name_(file.string()), memory_{InputFile(file, "WAV file").content()}, sound_(nullptr, sf_close) {
  SF_VIRTUAL_IO io = audio::sound_memory_io();
  sound_.reset(sf_open_virtual(&io, SFM_READ, &format_, &memory_));
  if (!sound_)
    throw InputError(name_, std::string("cannot be read, expected a WAV file: ") + sf_strerror(nullptr));
  require_whole(memory_.bytes, name_);
  if (format_.channels != 1)
    throw InputError(name_, std::to_string(format_.channels) + " channels, expected 1");
}

void WavReader::read(sf_count_t first, sf_count_t count, float* samples) const {
  if (sf_seek(get(), first, SEEK_SET) != first || sf_read_float(get(), samples, count) != count)
    throw InputError(name_, "ends early, expected " + std::to_string(first + count) + " samples");
}

}  // namespace rigsound::config
