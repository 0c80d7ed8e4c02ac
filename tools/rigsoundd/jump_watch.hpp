// Time that went by without blocks.
#pragma once

#include <cstdint>

namespace rigsound::daemon {

/// After a stall of up to a second blocks are caught up with, where there is no card (audio::Pacer); a longer
/// one (SIGSTOP, suspend, a machine that does something else) is a jump of the block clock. Thread: RT.
class JumpWatch {
 public:
  explicit JumpWatch(std::int64_t block_ns) : block_ns_(block_ns) {}

  /// A block begins, on a clock that counts while the machine is suspended. Returns how many should have
  /// begun since the one before, when it was over a second ago; else 0.
  std::uint64_t skipped(std::int64_t now_ns) noexcept {
    const std::int64_t gap_ns = last_ns_ == 0 ? 0 : now_ns - last_ns_;
    last_ns_ = now_ns;
    if (gap_ns <= kSecond_ns + block_ns_) return 0;
    return static_cast<std::uint64_t>((gap_ns + block_ns_ / 2) / block_ns_ - 1);
  }

 private:
  static constexpr std::int64_t kSecond_ns = 1'000'000'000;

  std::int64_t block_ns_, last_ns_ = 0;
};

}  // namespace rigsound::daemon
