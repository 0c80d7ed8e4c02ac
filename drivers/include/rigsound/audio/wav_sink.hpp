// Blocks into a WAV file that is either whole or not there.
#pragma once

#include <sndfile.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "rigsound/audio/audio_options.hpp"
#include "rigsound/audio/sink.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::audio {

/// 32 bit float unless another format is asked for, reproducible byte for byte. The file appears under its
/// name on commit(). Thread: OFF.
class WavSink : public Sink {
 public:
  struct Format {
    int rate = 48000, channels = 2, block = 64;  ///< Hz, channels, frames a block
    SampleFormat samples = SampleFormat::kFloat;
  };
  /// Called with the bytes of each block as they stand in the file's data chunk.
  using Tap = std::function<void(const void* bytes, std::size_t size)>;

  /// Errors: DeviceError when the file cannot be written.
  WavSink(const std::filesystem::path& file, const Format& format, Tap tap = {});

  void write(const float* block, std::uint64_t number) override;

  /// Finishes the file and puts it in place. Errors: DeviceError.
  void commit();

 private:
  std::filesystem::path path_;
  Format format_;
  Tap tap_;
  std::vector<unsigned char> bytes_;  ///< one block
  AtomicFile file_;
  std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound_;
};

}  // namespace rigsound::audio
