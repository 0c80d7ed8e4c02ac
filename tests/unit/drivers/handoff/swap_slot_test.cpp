// Nothing is lost, nothing is freed by the real-time thread, nothing is taken before room is made.
#include "rigsound/handoff/swap_slot.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

using namespace rigsound;

namespace {

struct Counted {
  explicit Counted(int n, int& alive) : number(n), alive_(alive) { ++alive_; }
  ~Counted() { --alive_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  int number;

 private:
  int& alive_;
};

}  // namespace

TEST_CASE("What is offered is swapped in once; what it replaces waits to be collected") {
  int alive = 0;
  {
    SwapSlot<Counted> slot;
    std::unique_ptr<Counted> current;
    CHECK_FALSE(slot.swap(current));
    slot.offer(std::make_unique<Counted>(1, alive));
    slot.offer(std::make_unique<Counted>(2, alive));  // 1 was not taken and goes
    CHECK(alive == 1);
    CHECK(slot.swap(current));
    CHECK(current->number == 2);
    CHECK_FALSE(slot.swap(current));
    slot.offer(std::make_unique<Counted>(3, alive));
    CHECK(slot.swap(current));
    CHECK(alive == 2);
    slot.offer(std::make_unique<Counted>(4, alive));
    CHECK_FALSE(slot.swap(current));  // 2 still waits
    CHECK(current->number == 3);
    CHECK(slot.collect()->number == 2);
    CHECK(slot.swap(current));
    CHECK(current->number == 4);
  }
  CHECK(alive == 0);
}

TEST_CASE("What is retired waits to be collected, and keeps its place until it is") {
  int alive = 0;
  SwapSlot<Counted> slot;
  auto first = std::make_unique<Counted>(1, alive), second = std::make_unique<Counted>(2, alive);
  CHECK(slot.retire(first));
  CHECK(first == nullptr);
  CHECK(alive == 2);
  CHECK_FALSE(slot.retire(second));
  CHECK(second->number == 2);
  CHECK(slot.collect()->number == 1);
  CHECK(slot.retire(second));
}

TEST_CASE("Two threads swap a thousand objects, each seen once and in order") {
  int made = 0;  // counted by the control thread alone: only it makes and frees
  SwapSlot<Counted> slot;
  std::atomic<bool> stop{false};
  std::atomic<int> newest{-1};
  std::thread real_time([&] {
    std::unique_ptr<Counted> current;
    while (!stop.load()) {
      if (slot.swap(current)) newest.store(current->number);
      std::this_thread::yield();
    }
    while (current && !slot.retire(current)) std::this_thread::yield();
  });
  for (int i = 0; i < 1000; ++i) {
    slot.offer(std::make_unique<Counted>(i, made));
    while (newest.load() != i) std::this_thread::yield();
    const std::unique_ptr<Counted> old = slot.collect();
    CHECK((old ? old->number : -1) == i - 1);
  }
  stop = true;
  while (!slot.collect()) std::this_thread::yield();
  real_time.join();
  CHECK(made == 0);
}
