// What a range of numbers holds, and what is said of one that it does not.
#include "rigsound/machine/fields.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace rigsound;

TEST_CASE("a range holds its ends and nothing beyond, 0 where that stands for none, and no NaN") {
  const Range range{0.5, 8, "s"};
  for (const double x : {0.5, 3.7, 8.0}) CHECK(range.holds(x));
  for (const double x : {0.499, 8.001, 0.0, -1.0, double(NAN), double(INFINITY)}) CHECK_FALSE(range.holds(x));
  CHECK(range.or_zero().holds(0));
  CHECK_FALSE(range.or_zero().holds(0.499));
  CHECK_FALSE(range.or_zero().holds(double(NAN)));
}

TEST_CASE("a range of multiples holds these alone") {
  const Range range = Range{32, 64, "frames"}.multiples_of(16);
  for (const double x : {32.0, 48.0, 64.0}) CHECK(range.holds(x));
  for (const double x : {33.0, 40.0, 48.5, 80.0, 16.0}) CHECK_FALSE(range.holds(x));
  CHECK(Range{0, 9}.whole().holds(9));
  CHECK_FALSE(Range{0, 9}.whole().holds(8.5));
}

TEST_CASE("a range says its ends, its unit, its step, and that it takes 0 where its ends do not say so") {
  CHECK(Range{0.001, 10, "s"}.text() == "0.001...10 s");
  CHECK(Range{0, 1}.text() == "0...1");
  CHECK(Range{5, 120, "Hz"}.or_zero().text() == "0 or 5...120 Hz");
  CHECK(Range{-9, -2}.or_zero().text() == "0 or -9...-2");
  CHECK(Range{0, 120, "Hz"}.or_zero().text() == "0...120 Hz");
  CHECK(Range{-9, 0}.or_zero().text() == "-9...0");
  CHECK(Range{-9, 9}.or_zero().text() == "-9...9");
  CHECK(Range{32, 64, "frames"}.multiples_of(32).text() == "32...64 frames, a multiple of 32");
  CHECK(Range{1, 8}.whole().text() == "1...8");
}

TEST_CASE("a number outside is told with its unit, and that it is broken only where its size is right") {
  CHECK(Range{0.001, 10, "s"}.problem(12) == "is 12 s, expected 0.001...10 s");
  CHECK(Range{0, 1}.problem(-2) == "is -2, expected 0...1");
  const Range whole = Range{1, 8}.whole();
  for (const double x : {1.5, 7.5})
    CHECK(whole.problem(x).find(", expected a whole number, 1...8") != std::string::npos);
  for (const double x : {0.5, 8.5, 9.0, 0.0})
    CHECK(whole.problem(x).find("a whole number") == std::string::npos);
  CHECK(Range{0, 64}.multiples_of(32).problem(3.5).find("a whole number") == std::string::npos);
}
