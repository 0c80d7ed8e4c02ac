// Sound into a file whose name says the format: .wav, .flac or .ogg.
#pragma once

#include <sndfile.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::audio {

/// Any other name, and standard output, means WAV.
constexpr std::array<std::string_view, 3> kSoundEndings = {".wav", ".flac", ".ogg"};

struct SoundFormat {
  int rate = 48000, channels = 2;  ///< Hz
  SampleFormat samples = SampleFormat::kFloat;
};

constexpr std::uint64_t kMostWavBytes = 0xFFFF0000;  ///< of samples; sizes in a WAV file have 32 bits

/// WAV holds the samples as they are; one that grows over its limit goes on as RF64 (EBU Tech 3306), for
/// which what is there is copied once. FLAC holds 24 bit of float and of 32 bit samples, Ogg Vorbis what is
/// heard of them; what is over full scale is clipped there. WAV and FLAC of the same samples are the same
/// bytes. Thread: OFF.
class SoundWriter {
 public:
  /// Writes under the temporary name of `file`, which must outlive it. Errors: DeviceError, also for a rate
  /// or a number of channels that the format does not hold.
  SoundWriter(const AtomicFile& file, const SoundFormat& format,
              std::uint64_t most_wav_bytes = kMostWavBytes);

  /// `bytes`: whole frames in the format's samples, as convert() makes them. Errors: DeviceError.
  void write(const void* bytes, std::size_t size);

  /// Errors: DeviceError. Call once, when all is written.
  void close();

  std::uint64_t clipped() const { return clipped_; }  ///< samples, so far

 private:
  void go_on_as_rf64();
  void write_integers(const unsigned char* bytes, std::size_t samples);
  void write_floats(const float* samples, std::size_t count);
  void require_all(sf_count_t wrote, std::size_t wanted);

  const AtomicFile& file_;
  SoundFormat format_;
  int type_;  ///< SF_FORMAT_WAV, SF_FORMAT_RF64, ...
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound_;
  std::vector<std::int32_t> integers_;
  std::uint64_t most_wav_bytes_, bytes_ = 0, clipped_ = 0;
};

}  // namespace rigsound::audio
