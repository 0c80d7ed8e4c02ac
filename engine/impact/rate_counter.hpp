// Impacts a second, as they were made.
#pragma once

#include <array>

#include "rigsound/machine/limits.hpp"

namespace rigsound::impact {

/// Counts over the last second, moved on by an eighth. Thread: RT.
class RateCounter {
 public:
  explicit RateCounter(double sample_rate) noexcept
      : chunk_s_(kChunk / sample_rate), part_chunks_(static_cast<int>(sample_rate / (kChunk * kParts))) {}

  /// One chunk with so many impacts.
  void add(int impacts) noexcept {
    counts_[part_] += impacts;
    total_ += impacts;
    if (covered_ < kParts * part_chunks_) ++covered_;
    if (++chunks_ < part_chunks_) return;
    chunks_ = 0;
    part_ = (part_ + 1) % kParts;
    total_ -= counts_[part_];
    counts_[part_] = 0;
    if (covered_ > (kParts - 1) * part_chunks_) covered_ = (kParts - 1) * part_chunks_;
  }

  double rate_hz() const noexcept { return covered_ > 0 ? total_ / (covered_ * chunk_s_) : 0.0; }

 private:
  static constexpr int kParts = 8;

  double chunk_s_;
  int part_chunks_;
  std::array<int, kParts> counts_{};
  int part_ = 0, chunks_ = 0, covered_ = 0, total_ = 0;  ///< covered: chunks that `total_` is of
};

}  // namespace rigsound::impact
