#include "rigsound/audio/wav_sink.hpp"

#include <string>

#include "rigsound/audio/sample_format.hpp"
#include "rigsound/device_error.hpp"

namespace rigsound::audio {
namespace {

constexpr std::uint64_t kMostBytes = 0xFFFF0000;  // sizes in a WAV file have 32 bits

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw DeviceError(path.string() + ": cannot be written: " + why);
}

int subtype(SampleFormat samples) {
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

SNDFILE* open(const AtomicFile& file, const std::filesystem::path& path, const WavSink::Format& format) {
  SF_INFO info{};
  info.samplerate = format.rate;
  info.channels = format.channels;
  info.format = SF_FORMAT_WAV | subtype(format.samples);
  SNDFILE* sound = sf_open(file.temporary().c_str(), SFM_WRITE, &info);
  if (sound == nullptr) fail(path, sf_strerror(nullptr));
  sf_command(sound, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);  // it carries the time of writing
  return sound;
}

}  // namespace

WavSink::WavSink(const std::filesystem::path& file, const Format& format, Tap tap)
    : path_(file),
      format_(format),
      tap_(std::move(tap)),
      bytes_(format.block * format.channels * bytes_per_sample(format.samples)),
      file_(file),
      sound_(open(file_, path_, format), sf_close) {}

void WavSink::write(const float* block, std::uint64_t number) {
  const std::size_t samples = format_.block * format_.channels;
  if ((number + 1) * bytes_.size() > kMostBytes) fail(path_, "a WAV file ends at 4 GB");
  convert(block, samples, number * samples, format_.samples, bytes_.data());
  const auto size = static_cast<sf_count_t>(bytes_.size());
  if (sf_write_raw(sound_.get(), bytes_.data(), size) != size) fail(path_, sf_strerror(sound_.get()));
  if (tap_) tap_(bytes_.data(), bytes_.size());
}

void WavSink::commit() {
  if (sf_close(sound_.release()) != 0) fail(path_, "it could not be finished");
  file_.commit();
}

}  // namespace rigsound::audio
