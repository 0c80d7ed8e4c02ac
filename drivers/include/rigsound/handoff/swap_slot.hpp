// An object from a control thread to a real-time thread that swaps it for its own, and the old one back.
#pragma once

#include <atomic>
#include <memory>

namespace rigsound {

/// One control thread, one real-time thread. Neither waits; the real-time thread never frees.
template <typename T>
class SwapSlot {
 public:
  SwapSlot() = default;
  SwapSlot(const SwapSlot&) = delete;
  SwapSlot& operator=(const SwapSlot&) = delete;
  ~SwapSlot() {
    delete offered_.load();
    delete retired_.load();
  }

  /// What was offered before and not taken is destroyed. Thread: CT
  void offer(std::unique_ptr<T> next) { delete offered_.exchange(next.release(), std::memory_order_acq_rel); }

  bool offered() const noexcept {
    return offered_.load(std::memory_order_relaxed) != nullptr;
  }  ///< Thread: any

  /// Takes what was offered and leaves `current` to be collected. False: nothing was offered, or the last one
  /// left has not been collected yet. Thread: RT
  bool swap(std::unique_ptr<T>& current) noexcept {
    if (retired_.load(std::memory_order_acquire) != nullptr) return false;
    T* const next = offered_.exchange(nullptr, std::memory_order_acquire);
    if (next == nullptr) return false;
    retired_.store(current.release(), std::memory_order_release);
    current.reset(next);
    return true;
  }

  /// Leaves `current` to be collected without taking another. False, and nothing done: the last one left has
  /// not been collected yet. Thread: RT
  bool retire(std::unique_ptr<T>& current) noexcept {
    if (retired_.load(std::memory_order_acquire) != nullptr) return false;
    retired_.store(current.release(), std::memory_order_release);
    return true;
  }

  /// What the real-time thread gave up, or nothing. Thread: CT
  std::unique_ptr<T> collect() {
    return std::unique_ptr<T>(retired_.exchange(nullptr, std::memory_order_acquire));
  }

 private:
  std::atomic<T*> offered_{nullptr}, retired_{nullptr};
};

}  // namespace rigsound
