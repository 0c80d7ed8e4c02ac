// Sound of any length, of which a piece at a time is in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rigsound/file/scratch_file.hpp"

namespace rigsound::analysis {

/// Samples at kAnalysisRate that do not change: in memory, or in a temporary file. Copies share them. Thread:
/// OFF, any.
class Samples {
 public:
  Samples() = default;
  Samples(std::vector<float> in_memory);  // NOLINT(google-explicit-constructor): a sound is a sound

  std::size_t size() const { return size_; }

  /// Samples [begin, end). Errors: DeviceError when a temporary file cannot be read back.
  std::vector<float> piece(std::size_t begin, std::size_t end) const;
  std::vector<float> all() const { return piece(0, size_); }

 private:
  friend class SampleFile;
  std::shared_ptr<const std::vector<float>> memory_;
  std::shared_ptr<const ScratchFile> file_;
  std::uint64_t at_ = 0;  ///< of the file, bytes
  std::size_t size_ = 0;
};

/// A temporary file for many sounds; it goes with the last of them. Thread: OFF, any.
class SampleFile {
 public:
  /// Errors: DeviceError when there is no room.
  Samples keep(const std::vector<float>& sound);

  /// One sound in pieces, in their order; no other may be kept before its last piece.
  void add(const std::vector<float>& piece, Samples& sound);

 private:
  std::shared_ptr<ScratchFile> file_ = std::make_shared<ScratchFile>();
};

}  // namespace rigsound::analysis
