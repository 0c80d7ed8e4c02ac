// Blocks into a sound file that is either whole or not there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "rigsound/audio/sink.hpp"
#include "rigsound/audio/sound_writer.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::audio {

/// 32 bit float unless another format is asked for, reproducible byte for byte; Ogg is not. The file appears
/// under its name on commit(). Thread: OFF.
class FileSink : public Sink {
 public:
  struct Format : SoundFormat {
    int block = 64;  ///< frames
  };
  /// Called with the bytes of one or more blocks in the format's samples, as a WAV file has them in its data
  /// chunk.
  using Tap = std::function<void(const void* bytes, std::size_t size)>;

  /// Errors: DeviceError when the file cannot be written.
  FileSink(const std::filesystem::path& file, const Format& format, Tap tap = {});

  void write(const float* block, std::uint64_t number) override;
  void skip(std::uint64_t blocks) override;

  /// Finishes the file and puts it in place. Errors: DeviceError.
  void commit();

  /// Samples that the file does not hold as they were.
  std::uint64_t clipped() const { return writer_.clipped(); }

 private:
  void advance();
  void write_held();

  Format format_;
  Tap tap_;
  std::size_t block_bytes_;
  std::vector<unsigned char> bytes_;  ///< whole blocks, written at once
  std::size_t held_ = 0;              ///< bytes that wait for it
  AtomicFile file_;
  SoundWriter writer_;
};

}  // namespace rigsound::audio
