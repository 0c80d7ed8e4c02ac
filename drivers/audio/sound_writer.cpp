#include "rigsound/audio/sound_writer.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/file/ending.hpp"

namespace rigsound::audio {
namespace {

constexpr std::size_t kVorbisFrames = 4096;  // at a time: its encoder keeps them on the stack
constexpr std::size_t kMostHeadBytes = 512;  // of an RF64, as libsndfile writes it
constexpr std::size_t kCopied =
    100 * 10'080;  // bytes at a time: whole frames of any format and 1 to 8 channels

using Sound = std::unique_ptr<SNDFILE, int (*)(SNDFILE*)>;

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw DeviceError(path.string() + ": cannot be written: " + why);
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

int type_of(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".flac") return SF_FORMAT_FLAC;
  return ending == ".ogg" ? SF_FORMAT_OGG : SF_FORMAT_WAV;
}

int subtype_of(int type, SampleFormat samples) {
  if (type == SF_FORMAT_FLAC) return samples == SampleFormat::kS16 ? SF_FORMAT_PCM_16 : SF_FORMAT_PCM_24;
  return type == SF_FORMAT_OGG ? SF_FORMAT_VORBIS : wav_subtype(samples);
}

Sound open_for_writing(const AtomicFile& file, const SoundFormat& format, int type) {
  SF_INFO info{};
  info.samplerate = format.rate;
  info.channels = format.channels;
  info.format = type | subtype_of(type, format.samples);
  // Never made anew: a signal may just have taken it away.
  const int descriptor = ::open(file.temporary().c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) refuse(file.target(), std::strerror(errno));
  Sound sound(sf_open_fd(descriptor, SFM_WRITE, &info, SF_TRUE), sf_close);
  if (!sound)
    refuse(file.target(), std::to_string(format.channels) + " channels at " + std::to_string(format.rate) +
                              " Hz: " + sf_strerror(nullptr));
  sf_command(sound.get(), SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  sf_command(sound.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
  double quality = 0.8;
  sf_command(sound.get(), SFC_SET_VBR_ENCODING_QUALITY, &quality, sizeof quality);
  return sound;
}

/// libsndfile leaves it out of no RF64 of floats: it holds the time of writing, and peaks that it does not
/// know.
void blank_peak_chunk(const std::filesystem::path& file) {
  std::fstream wav(file, std::ios::in | std::ios::out | std::ios::binary);
  std::string head(kMostHeadBytes, '\0');
  wav.read(head.data(), static_cast<std::streamsize>(head.size()));
  const std::size_t at = head.find("PEAK");
  if (at == std::string::npos || at + 8 > head.size()) return;
  const auto size = static_cast<unsigned char>(head[at + 4]);
  wav.clear();
  wav.seekp(static_cast<std::streamoff>(at));
  wav.write("JUNK", 4);
  wav.seekp(static_cast<std::streamoff>(at + 8));
  wav.write(std::string(size, '\0').data(), size);
}

}  // namespace

SoundWriter::SoundWriter(const AtomicFile& file, const SoundFormat& format, std::uint64_t most_wav_bytes)
    : file_(file),
      format_(format),
      type_(type_of(file.target())),
      sound_(open_for_writing(file, format, type_)),
      most_wav_bytes_(most_wav_bytes) {}

/// Its head is longer: another file takes the place of the one begun.
void SoundWriter::go_on_as_rf64() {
  close();
  SF_INFO info{};
  const Sound begun(sf_open(file_.temporary().c_str(), SFM_READ, &info), sf_close);
  if (!begun) refuse(file_.target(), sf_strerror(nullptr));
  const AtomicFile larger(file_.target());
  type_ = SF_FORMAT_RF64;
  sound_ = open_for_writing(larger, format_, type_);
  std::vector<char> bytes(kCopied);
  for (sf_count_t got = 0; (got = sf_read_raw(begun.get(), bytes.data(), kCopied)) > 0;)
    require_all(sf_write_raw(sound_.get(), bytes.data(), got), static_cast<std::size_t>(got));
  std::error_code error;
  std::filesystem::rename(larger.temporary(), file_.temporary(), error);
  if (error) refuse(file_.target(), error.message());
}

void SoundWriter::write(const void* bytes, std::size_t size) {
  bytes_ += size;
  if (type_ == SF_FORMAT_WAV && bytes_ > most_wav_bytes_) go_on_as_rf64();
  if (type_ == SF_FORMAT_WAV || type_ == SF_FORMAT_RF64)
    return require_all(sf_write_raw(sound_.get(), bytes, static_cast<sf_count_t>(size)), size);
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
  if (wrote != static_cast<sf_count_t>(wanted)) refuse(file_.target(), sf_strerror(sound_.get()));
}

void SoundWriter::close() {
  if (sf_close(sound_.release()) != 0) refuse(file_.target(), "it could not be finished: disk full?");
  if (type_ == SF_FORMAT_RF64) blank_peak_chunk(file_.temporary());
}

}  // namespace rigsound::audio
