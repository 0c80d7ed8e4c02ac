#include "rigsound/audio/sample_format.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace rigsound::audio;

namespace {

template <typename T>
std::vector<T> converted(const std::vector<float>& in, SampleFormat format, std::uint64_t first = 0) {
  std::vector<T> out(in.size());
  convert(in.data(), in.size(), first, format, out.data());
  return out;
}

}  // namespace

TEST_CASE("Float passes unchanged, S32 and S24 round to nearest and clip at full scale") {
  const std::vector<float> in = {0.0F,  0.5F, -0.5F, 1.0F,
                                 -1.0F, 2.0F, -2.0F, std::numeric_limits<float>::quiet_NaN()};
  CHECK(std::memcmp(converted<float>(in, SampleFormat::kFloat).data(), in.data(), in.size() * 4) == 0);
  const auto s32 = converted<std::int32_t>(in, SampleFormat::kS32);
  CHECK(s32[1] == 1 << 30);
  CHECK(s32[2] == -(1 << 30));
  CHECK(s32[3] == std::numeric_limits<std::int32_t>::max());
  CHECK(s32[5] == std::numeric_limits<std::int32_t>::max());
  CHECK(s32[6] == std::numeric_limits<std::int32_t>::min());
  unsigned char s24[3] = {};
  const float half = 0.5F;
  convert(&half, 1, 0, SampleFormat::kS24_3, s24);
  CHECK((s24[0] | s24[1] << 8 | s24[2] << 16) == 1 << 22);
}

TEST_CASE("S16 dither is triangular, without bias, and tied to the position of the sample") {
  const std::size_t n = 200000;
  const float level = 100.25F / 32768;
  const auto out = converted<std::int16_t>(std::vector<float>(n, level), SampleFormat::kS16);
  double sum = 0, squares = 0;
  for (const std::int16_t x : out) {
    CHECK_MESSAGE(std::fabs(x - 100.25) < 1.75, "beyond +-1 LSB and rounding");
    sum += x - 100.25;
    squares += (x - 100.25) * (x - 100.25);
  }
  // Triangular dither of +-1 LSB makes the total error 1/4 LSB^2 whatever the level (variance 1/6 + 1/12).
  CHECK(sum / n == doctest::Approx(0).epsilon(0.005));
  CHECK(squares / n == doctest::Approx(0.25).epsilon(0.02));

  const auto shifted = converted<std::int16_t>(std::vector<float>(n - 5, level), SampleFormat::kS16, 5);
  CHECK(std::equal(shifted.begin(), shifted.end(), out.begin() + 5));
}

TEST_CASE("Digital silence stays silent in S16") {
  const auto out = converted<std::int16_t>(std::vector<float>(1000, 0.0F), SampleFormat::kS16);
  CHECK(out == std::vector<std::int16_t>(1000, 0));
}

TEST_CASE("Every format is found by its name, and other words are none") {
  for (const SampleFormat format : {SampleFormat::kAuto, SampleFormat::kFloat, SampleFormat::kS32,
                                    SampleFormat::kS24_3, SampleFormat::kS16})
    CHECK(sample_format_by_name(name(format)) == format);
  for (const char* none : {"", "float", "S8", "S16 ", "FLOATS"}) CHECK_FALSE(sample_format_by_name(none));
}

TEST_CASE("The ends of every integer format are just below full scale and at it") {
  const std::vector<float> in = {-1.0F, 1.0F, 0.99999994F, -0.5F / 8388608, 0.5F / 8388608};
  const auto s32 = converted<std::int32_t>(in, SampleFormat::kS32);
  CHECK(s32[0] == std::numeric_limits<std::int32_t>::min());
  CHECK(s32[1] == std::numeric_limits<std::int32_t>::max());
  CHECK(s32[2] == std::numeric_limits<std::int32_t>::max() - 127);  // 2^31 (1 - 2^-24)
  std::vector<unsigned char> bytes(3 * in.size());
  convert(in.data(), in.size(), 0, SampleFormat::kS24_3, bytes.data());
  const auto s24 = [&](std::size_t i) {
    const int value = bytes[3 * i] | bytes[3 * i + 1] << 8 | bytes[3 * i + 2] << 16;
    return value >= 1 << 23 ? value - (1 << 24) : value;
  };
  CHECK(s24(0) == -(1 << 23));
  CHECK(s24(1) == (1 << 23) - 1);
  CHECK(s24(2) == (1 << 23) - 1);
  CHECK(s24(3) == 0);  // halves go up
  CHECK(s24(4) == 1);
}
