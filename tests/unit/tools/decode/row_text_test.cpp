// The fast way prints what the slow one does.
#include "decode/row_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace rigsound::tools;

namespace {

std::string seconds(double x) {
  fmt::memory_buffer text;
  append_seconds(text, x);
  return fmt::to_string(text);
}

std::string value(double x) {
  fmt::memory_buffer text;
  append_value(text, x);
  return fmt::to_string(text);
}

void check(double x) {
  CAPTURE(x);
  CHECK(seconds(x) == fmt::format("{:.6f}", x));
  CHECK(value(x) == fmt::format("{:.10g}", x));
}

}  // namespace

TEST_CASE("Seconds and values are printed as fmt prints them, whatever they are") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, -0.0, 1e10, 9999999999.0, 9999.9999996, 1e-4, 1e-5, 0.0000995, 1e15, 1e300,
                         infinity, -infinity, std::nan("")})
    check(x);
  std::mt19937_64 random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto n = static_cast<double>(random() % 20'000'000'000) - 1e9;
    for (const double unit : {1e-9, 1e-6, 0.5e-6, 1e-3, 0.125, 1.0, 1.0 / 3}) check(n * unit);
    check(std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 100) - 100));
  }
}
