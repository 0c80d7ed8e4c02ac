#include "rigsound/audio/sound_writer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::audio {
namespace {

constexpr std::uint64_t kMostWavBytes = 0xFFFF0000;  // sizes in a WAV file have 32 bits
constexpr std::size_t kVorbisFrames = 4096;          // at a time: its encoder keeps them on the stack

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw DeviceError(path.string() + ": cannot be written: " + why);
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

int wav_subtype(SampleFormat samples) {
  switch (samples) {
    case SampleFormat::kS32:
      return SF_FORMAT_PCM_32;
    case SampleFormat::kS24_3:
      return SF_FORMAT_PCM_24;
    case SampleFormat::kS16:
      return SF_FORMAT_PCM_16;
    default:
      return SF_FORMAT_FLOAT;
  }
}

int libsndfile_format(const std::filesystem::path& path, SampleFormat samples) {
  const std::string ending = ending_of(path);
  if (ending == ".flac")
    return SF_FORMAT_FLAC | (samples == SampleFormat::kS16 ? SF_FORMAT_PCM_16 : SF_FORMAT_PCM_24);
  if (ending == ".ogg") return SF_FORMAT_OGG | SF_FORMAT_VORBIS;
  return SF_FORMAT_WAV | wav_subtype(samples);
}

SNDFILE* open_for_writing(const AtomicFile& file, const SoundFormat& format) {
  SF_INFO info{};
  info.samplerate = format.rate;
  info.channels = format.channels;
  info.format = libsndfile_format(file.target(), format.samples);
  SNDFILE* sound = sf_open(file.temporary().c_str(), SFM_WRITE, &info);
  if (sound == nullptr)
    refuse(file.target(), std::to_string(format.channels) + " channels at " + std::to_string(format.rate) +
                              " Hz: " + sf_strerror(nullptr));
  sf_command(sound, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  sf_command(sound, SFC_SET_CLIPPING, nullptr, SF_TRUE);
  double quality = 0.8;
  sf_command(sound, SFC_SET_VBR_ENCODING_QUALITY, &quality, sizeof quality);
  return sound;
}

}  // namespace

SoundWriter::SoundWriter(const AtomicFile& file, const SoundFormat& format)
    : path_(file.target()),
      format_(format),
      as_it_is_((libsndfile_format(path_, format.samples) & SF_FORMAT_TYPEMASK) == SF_FORMAT_WAV),
      sound_(open_for_writing(file, format), sf_close) {}

void SoundWriter::write(const void* bytes, std::size_t size) {
  if (as_it_is_) {
    bytes_ += size;
    if (bytes_ > kMostWavBytes) refuse(path_, "a WAV file ends at 4 GB");
    return require_all(sf_write_raw(sound_.get(), bytes, static_cast<sf_count_t>(size)), size);
  }
  const std::size_t samples = size / bytes_per_sample(format_.samples);
  if (bytes_per_sample(format_.samples) == sizeof(float) && format_.samples != SampleFormat::kS32)
    write_floats(static_cast<const float*>(bytes), samples);
  else
    write_integers(static_cast<const unsigned char*>(bytes), samples);
}

void SoundWriter::write_floats(const float* samples, std::size_t count) {
  clipped_ += static_cast<std::uint64_t>(
      std::count_if(samples, samples + count, [](float x) { return !(std::fabs(x) <= 1); }));
  const std::size_t most = kVorbisFrames * static_cast<std::size_t>(format_.channels);
  for (std::size_t at = 0; at < count; at += most) {
    const std::size_t some = std::min(most, count - at);
    require_all(sf_write_float(sound_.get(), samples + at, static_cast<sf_count_t>(some)), some);
  }
}

/// Left-aligned in 32 bits, as libsndfile takes integers of any size.
void SoundWriter::write_integers(const unsigned char* bytes, std::size_t samples) {
  const std::size_t each = bytes_per_sample(format_.samples);
  integers_.assign(samples, 0);
  for (std::size_t i = 0; i < samples; ++i)
    std::memcpy(reinterpret_cast<unsigned char*>(&integers_[i]) + (sizeof(std::int32_t) - each),
                bytes + i * each, each);
  require_all(sf_write_int(sound_.get(), integers_.data(), static_cast<sf_count_t>(samples)), samples);
}

void SoundWriter::require_all(sf_count_t wrote, std::size_t wanted) {
  if (wrote != static_cast<sf_count_t>(wanted)) refuse(path_, sf_strerror(sound_.get()));
}

void SoundWriter::close() {
  if (sf_close(sound_.release()) != 0) refuse(path_, "it could not be finished: disk full?");
}

}  // namespace rigsound::audio
