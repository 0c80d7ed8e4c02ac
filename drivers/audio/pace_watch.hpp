// Whether a sound card takes blocks as fast as it plays them, or as fast as it can.
#pragma once

#include <algorithm>
#include <cstdint>

namespace rigsound::audio {

/// Card and machine may drift apart, so time is counted anew each second. Thread: RT.
class PaceWatch {
 public:
  /// `buffer_ns`: sound that the card holds.
  void start(std::int64_t now_ns, double block_ns, double buffer_ns) noexcept {
    begin_ns_ = now_ns;
    block_ns_ = block_ns;
    allowed_ns_ = buffer_ns + kMargin_ns;
    blocks_ = 0;
  }

  /// One more block was taken. False: more than the card can have played and holds.
  bool taken(std::int64_t now_ns) noexcept {
    ++blocks_;
    const bool possible = ahead_ns(now_ns) <= allowed_ns_;
    if (possible && now_ns - begin_ns_ > kWindow_ns) {
      begin_ns_ = now_ns;
      blocks_ = 0;
    }
    return possible;
  }

  /// How much sooner than played the blocks were taken.
  double ahead_ns(std::int64_t now_ns) const noexcept {
    return static_cast<double>(blocks_) * block_ns_ - static_cast<double>(now_ns - begin_ns_);
  }

 private:
  static constexpr double kMargin_ns = 0.1e9;  // of resamplers and mixers in front of the card
  static constexpr std::int64_t kWindow_ns = 1'000'000'000;

  std::int64_t begin_ns_ = 0, blocks_ = 0;
  double block_ns_ = 0, allowed_ns_ = 0;
};

}  // namespace rigsound::audio
