#include "sound_set/click_store.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace rigsound;

TEST_CASE("clicks lie apart in one block, at multiples of 64 bytes, and outlive the store") {
  std::vector<std::shared_ptr<float>> rooms;
  constexpr std::size_t kSamples = 1001;
  {
    config::ClickStore store(std::size_t{1} << 16);
    for (int i = 0; i < 40; ++i) {
      rooms.push_back(store.room(kSamples));
      std::fill_n(rooms.back().get(), kSamples, static_cast<float>(i));
    }
    CHECK(store.room(0) == nullptr);
  }
  int beside = 0;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const float* const room = rooms[i].get();
    CHECK(reinterpret_cast<std::uintptr_t>(room) % 64 == 0);
    CHECK(std::count(room, room + kSamples, static_cast<float>(i)) == kSamples);
    beside += i > 0 && room - rooms[i - 1].get() == 1008;
  }
  CHECK(beside == 37);  // sixteen in a block
}

TEST_CASE("clicks whose bytes are a multiple of 64 lie without a gap") {
  config::ClickStore store(std::size_t{1} << 16);
  const std::shared_ptr<float> first = store.room(16), second = store.room(17), third = store.room(1);
  CHECK(second.get() - first.get() == 16);
  CHECK(third.get() - second.get() == 32);
}

TEST_CASE("more than a block takes a block of its own") {
  config::ClickStore store;
  const std::shared_ptr<float> room = store.room(3 * LargeBlock::kPiece / sizeof(float));
  CHECK(room.get()[3 * LargeBlock::kPiece / sizeof(float) - 1] == 0);
}
