#include "backoff.hpp"

#include <doctest/doctest.h>

using namespace rigsound;

TEST_CASE("The first attempt is due at once, the next after 0.1 s doubling to 5 s") {
  Backoff backoff;
  std::int64_t now_ms = 0;
  CHECK(backoff.due(now_ms));
  for (const std::int64_t pause_ms : {100, 200, 400, 800, 1600, 3200, 5000, 5000, 5000}) {
    backoff.failed(now_ms);
    CHECK(backoff.left_ms(now_ms) == pause_ms);
    CHECK(backoff.left_ms(now_ms + 30) == pause_ms - 30);
    CHECK_FALSE(backoff.due(now_ms + pause_ms - 1));
    now_ms += pause_ms;
    CHECK(backoff.due(now_ms));
    CHECK(backoff.left_ms(now_ms + 1000) == 0);
  }
}

TEST_CASE("A device that worked is looked for again after the shortest pause") {
  Backoff backoff;
  for (int i = 0; i < 10; ++i) backoff.failed(0);
  backoff.worked(1000);
  CHECK_FALSE(backoff.due(1099));
  CHECK(backoff.due(1100));
  backoff.failed(2000);
  CHECK(backoff.left_ms(2000) == 100);
  backoff.failed(2100);
  CHECK(backoff.left_ms(2100) == 200);
}
