// Time without blocks, and what a session makes of it.
#include "jump_watch.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using rigsound::daemon::JumpWatch;

namespace {

constexpr std::int64_t kBlock_ns = 1'333'333, kSecond_ns = 1'000'000'000;

}  // namespace

TEST_CASE("Blocks in time, late ones and stalls of up to a second skip nothing") {
  JumpWatch watch(kBlock_ns);
  std::int64_t now_ns = 77 * kSecond_ns;  // however long the machine has been up
  CHECK(watch.skipped(now_ns) == 0);
  for (const std::int64_t gap_ns :
       {kBlock_ns, std::int64_t{0}, 10 * kBlock_ns, kSecond_ns / 2, kSecond_ns, kSecond_ns + kBlock_ns})
    CHECK(watch.skipped(now_ns += gap_ns) == 0);
}

TEST_CASE("After a longer stall the blocks that should have begun in it are told, once") {
  JumpWatch watch(kBlock_ns);
  std::int64_t now_ns = 5;
  watch.skipped(now_ns);
  CHECK(watch.skipped(now_ns += 3 * kSecond_ns) == 2249);  // 2250 blocks of time, and one begins
  CHECK(watch.skipped(now_ns += kBlock_ns) == 0);
  CHECK(watch.skipped(now_ns += kSecond_ns + 2 * kBlock_ns) == 751);
  CHECK(watch.skipped(now_ns += 8 * 3600 * kSecond_ns) ==
        8 * 3600 * 750 + 5 - 1);  // a block is a little short
}
