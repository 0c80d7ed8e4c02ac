// A text that is a number and nothing else.
#include "rigsound/number_of.hpp"

#include <doctest/doctest.h>

#include <cstdint>

using rigsound::number_of;

TEST_CASE("a number is read when it is all of a text") {
  CHECK(number_of<int>("12") == 12);
  CHECK(number_of<int>("-12") == -12);
  CHECK(number_of<double>("-2.5e-1") == -0.25);
  CHECK(number_of<unsigned>("fF", 16) == 255U);
  for (const char* other : {"", " 12", "12 ", "12x", "x12", "+12", "1.5", "0x12"}) {
    CAPTURE(other);
    CHECK_FALSE(number_of<int>(other));
  }
  for (const char* other : {"", "1.5.2", "1.5 ", "1,5"}) {
    CAPTURE(other);
    CHECK_FALSE(number_of<double>(other));
  }
  CHECK_FALSE(number_of<unsigned>("g", 16));
  CHECK(number_of<int>(std::string_view("123", 2)) == 12);  // what is behind its end is not its own
}

TEST_CASE("a number that its type cannot hold is none") {
  CHECK(number_of<std::uint16_t>("65535") == 65535);
  CHECK_FALSE(number_of<std::uint16_t>("65536"));
  CHECK_FALSE(number_of<std::uint16_t>("-1"));
  CHECK(number_of<std::int64_t>("9223372036854775807") == INT64_MAX);
  CHECK_FALSE(number_of<std::int64_t>("9223372036854775808"));
  CHECK_FALSE(number_of<double>("1e999"));
}
