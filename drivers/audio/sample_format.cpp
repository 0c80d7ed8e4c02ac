#include "rigsound/audio/sample_format.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include "rigsound/dsp/random.hpp"

namespace rigsound::audio {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"auto", "FLOAT", "S32", "S24_3", "S16"};
constexpr std::uint64_t kDitherKey = 0x5a4d1f3b9c27e681ULL;

std::int32_t to_integer(double sample, double scale) noexcept {
  const double scaled = std::floor(sample * scale + 0.5);
  if (!(scaled > -scale)) return static_cast<std::int32_t>(-scale);
  return static_cast<std::int32_t>(scaled < scale - 1 ? scaled : scale - 1);
}

// The sum of two uniform numbers, +-1 LSB; both halves of one 64-bit draw.
double triangular(std::uint64_t position) noexcept {
  const std::uint64_t bits = dsp::mix64(kDitherKey + 0x9e3779b97f4a7c15ULL * position);
  const auto high = static_cast<double>(bits >> 32), low = static_cast<double>(bits & 0xffffffffU);
  return (high - low) * 0x1p-32;
}

void put_s16(double sample, std::uint64_t position, unsigned char* out) noexcept {
  const double dither = sample == 0 ? 0.0 : triangular(position) * 0x1p-15;
  const auto value = static_cast<std::int16_t>(to_integer(sample + dither, 0x1p15));
  std::memcpy(out, &value, 2);
}

}  // namespace

std::string_view name(SampleFormat format) { return kNames[static_cast<std::size_t>(format)]; }

std::optional<SampleFormat> sample_format_by_name(std::string_view text) {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == text) return static_cast<SampleFormat>(i);
  return std::nullopt;
}

std::size_t bytes_per_sample(SampleFormat format) {
  constexpr std::array<std::size_t, 5> kBytes = {4, 4, 4, 3, 2};
  return kBytes[static_cast<std::size_t>(format)];
}

void convert(const float* in, std::size_t count, std::uint64_t first_sample, SampleFormat format,
             void* out) noexcept {
  auto* bytes = static_cast<unsigned char*>(out);
  switch (format) {
    case SampleFormat::kAuto:
    case SampleFormat::kFloat:
      std::memcpy(bytes, in, count * sizeof(float));
      return;
    case SampleFormat::kS32:
      for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t value = to_integer(in[i], 0x1p31);
        std::memcpy(bytes + 4 * i, &value, 4);
      }
      return;
    case SampleFormat::kS24_3:
      for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t value = to_integer(in[i], 0x1p23);
        std::memcpy(bytes + 3 * i, &value, 3);
      }
      return;
    case SampleFormat::kS16:
      for (std::size_t i = 0; i < count; ++i) put_s16(in[i], first_sample + i, bytes + 2 * i);
  }
}

}  // namespace rigsound::audio
