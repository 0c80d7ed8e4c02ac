#include "decode/row_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

namespace rigsound::tools {
namespace {

constexpr double kMicro = 1e6;
constexpr double kMostMicros = 1e15;  // beyond, a double no longer tells them apart
constexpr double kTenDigits_micros = 1e10;

/// What becomes of zeros at the end of the six decimals.
enum class Zeros { kKept, kDropped };

void append(fmt::memory_buffer& text, const std::string& more) {
  text.append(more.data(), more.data() + more.size());
}

void append_micros(fmt::memory_buffer& text, std::uint64_t micros, Zeros zeros) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), micros / 1'000'000);
  text.append(digits.data(), end.ptr);
  auto part = static_cast<unsigned>(micros % 1'000'000);
  if (part == 0 && zeros == Zeros::kDropped) return;
  std::array<char, 7> decimals;
  decimals[0] = '.';
  for (std::size_t i = 6; i > 0; --i, part /= 10) decimals[i] = static_cast<char>('0' + part % 10);
  std::size_t size = decimals.size();
  while (zeros == Zeros::kDropped && decimals[size - 1] == '0') --size;
  text.append(decimals.data(), decimals.data() + size);
}

}  // namespace

void append_seconds(fmt::memory_buffer& text, double seconds) {
  const double micros = seconds * kMicro, whole = std::floor(micros), part = micros - whole;
  const bool near_a_half = std::fabs(part - 0.5) < 1e-3;  // which way it goes, its exact value says
  if (!(micros >= 0 && micros < kMostMicros) || near_a_half || std::signbit(seconds)) {
    append(text, fmt::format("{:.6f}", seconds));
    return;
  }
  append_micros(text, static_cast<std::uint64_t>(whole) + (part > 0.5 ? 1 : 0), Zeros::kKept);
}

void append_value(fmt::memory_buffer& text, double value) {
  const double micros = std::fabs(value) * kMicro, whole = std::floor(micros);
  const bool short_one = micros == whole && micros < kTenDigits_micros && (micros >= 100 || value == 0);
  if (!short_one || (value == 0 && std::signbit(value))) {
    append(text, fmt::format("{:.10g}", value));
    return;
  }
  if (value < 0) text.push_back('-');
  append_micros(text, static_cast<std::uint64_t>(whole), Zeros::kDropped);
}

}  // namespace rigsound::tools
