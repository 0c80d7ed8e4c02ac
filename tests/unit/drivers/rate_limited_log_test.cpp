#include "rate_limited_log.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace rigsound;

TEST_CASE("The first warning is written at once, then one a second with the number of those left out") {
  std::vector<std::string> written;
  RateLimitedLog log([&](const std::string& text) { written.push_back(text); });
  log.add("a", 5000);
  CHECK(written == std::vector<std::string>{"a"});
  log.add("b", 5001);
  log.add("c", 5999);
  CHECK(written.size() == 1);
  log.add("d", 6000);
  CHECK(written.back() == "d (and 2 more warnings)");
  log.add("e", 7000);
  CHECK(written.back() == "e");
}
