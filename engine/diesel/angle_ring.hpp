// The last angle samples that a layer has produced.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rigsound::diesel {

/// Positions count angle samples since the start and never wrap; before position 0 there is silence.
class AngleRing {
 public:
  /// Holds the last `size` samples, a power of two. Thread: OFF.
  explicit AngleRing(int size) : samples_(static_cast<std::size_t>(size), 0.0F), mask_(size - 1) {}

  std::int64_t end() const noexcept { return end_; }  ///< first position not yet produced

  void push(const double* values, int count) noexcept {  ///< Thread: RT
    for (int i = 0; i < count; ++i, ++end_)
      samples_[static_cast<std::size_t>(end_ & mask_)] = static_cast<float>(values[i]);
  }

  void clear() noexcept { std::fill(samples_.begin(), samples_.end(), 0.0F); }  ///< Thread: RT

  void read(std::int64_t first, int count, float* out) const noexcept {  ///< Thread: RT
    const std::int64_t at = first & mask_, before_wrap = std::min<std::int64_t>(count, mask_ + 1 - at);
    std::copy_n(samples_.begin() + at, before_wrap, out);
    std::copy_n(samples_.begin(), count - before_wrap, out + before_wrap);
  }

 private:
  std::vector<float> samples_;
  std::int64_t mask_, end_ = 0;
};

}  // namespace rigsound::diesel
