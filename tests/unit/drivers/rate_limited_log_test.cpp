#include "rate_limited_log.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace rigsound;

TEST_CASE(
    "The first warning of a kind is written at once, then one a minute with the number of those left out") {
  std::vector<std::string> written;
  RateLimitedLog log([&](const std::string& text) { written.push_back(text); });
  log.add("refused", "a", 5000);
  CHECK(written == std::vector<std::string>{"a"});
  log.add("refused", "b", 5001);
  log.add("refused", "c", 64'999);
  CHECK(written.size() == 1);
  log.add("rejected", "x", 64'999);
  CHECK(written.back() == "x");
  log.add("refused", "d", 65'000);
  CHECK(written.back() == "d (and 2 more of this kind)");
  log.add("refused", "e", 125'000);
  CHECK(written.back() == "e");
}
