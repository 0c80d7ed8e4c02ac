// The newest value from one thread to another; neither ever waits.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace rigsound {

/// One writer, one reader. The reader always sees a whole value: the newest one written, or the initial.
template <typename T>
class TripleBuffer {
  static_assert(std::is_trivially_copyable_v<T>, "a copy must not allocate");

 public:
  explicit TripleBuffer(const T& initial) : slots_{initial, initial, initial} {}

  void write(const T& value) noexcept {  ///< Thread: the writer's
    slots_[back_] = value;
    back_ = middle_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Valid until the next call. Thread: the reader's, RT.
  const T& read() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return slots_[front_];
  }

 private:
  static constexpr std::uint8_t kIndex = 3, kFresh = 4;

  std::array<T, 3> slots_;
  std::uint8_t back_ = 0;                // the writer's
  std::atomic<std::uint8_t> middle_{1};  // handed over, with kFresh when the writer did it last
  std::uint8_t front_ = 2;               // the reader's
};

}  // namespace rigsound
