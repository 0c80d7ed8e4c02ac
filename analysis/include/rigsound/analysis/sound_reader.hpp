// Pieces of a long recording, read where they are looked at.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

namespace rigsound::analysis {

struct SoundShape {
  long frames = 0;
  int rate = 0;  ///< Hz, of the file
  int channels = 0;

  double seconds() const { return static_cast<double>(frames) / rate; }
};

/// Any file that libsndfile reads, at its own rate. Thread: OFF, one at a time.
class SoundReader {
 public:
  /// Errors: InputError when it is no sound file or holds nothing.
  explicit SoundReader(const std::filesystem::path& file);
  ~SoundReader();
  SoundReader(SoundReader&&) noexcept;

  const SoundShape& shape() const { return shape_; }

  /// Frames [from, from + count), each the mean of its channels, full scale 1; 0 outside the file and for a
  /// sample that is not finite.
  void read(long from, std::size_t count, float* to);
  std::vector<float> read(long from, std::size_t count);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  SoundShape shape_;
  long at_ = 0;
};

}  // namespace rigsound::analysis
