#include "rigsound/can/signal_reading.hpp"

#include <algorithm>
#include <cstring>

namespace rigsound::can {
namespace {

std::uint64_t low_bits(int count) { return count >= 64 ? ~0ULL : (1ULL << count) - 1; }

std::uint64_t extract_intel(const BitField& field, const Frame& frame) {
  std::uint64_t raw = 0;
  for (int taken = 0; taken < field.length;) {
    const int bit = field.start_bit + taken, in_byte = bit % 8;
    const int count = std::min(8 - in_byte, field.length - taken);
    const std::uint64_t part = (frame.data[bit / 8] >> in_byte) & low_bits(count);
    raw |= part << taken;
    taken += count;
  }
  return raw;
}

std::uint64_t extract_motorola(const BitField& field, const Frame& frame) {
  std::uint64_t raw = 0;
  int byte = field.start_bit / 8, top = field.start_bit % 8;
  for (int left = field.length; left > 0; ++byte, top = 7) {
    const int count = std::min(top + 1, left);
    raw = (raw << count) | ((frame.data[byte] >> (top + 1 - count)) & low_bits(count));
    left -= count;
  }
  return raw;
}

double number(ValueType type, int length, std::uint64_t raw) {
  switch (type) {
    case ValueType::kFloat32: {
      const auto bits = static_cast<std::uint32_t>(raw);
      float x = 0;
      std::memcpy(&x, &bits, sizeof x);
      return x;
    }
    case ValueType::kFloat64: {
      double x = 0;
      std::memcpy(&x, &raw, sizeof x);
      return x;
    }
    case ValueType::kSigned:
      if (((raw >> (length - 1)) & 1U) != 0) raw |= ~low_bits(length);
      return static_cast<double>(static_cast<std::int64_t>(raw));
    case ValueType::kUnsigned:
      break;
  }
  return static_cast<double>(raw);
}

/// The signal map's word on the raw value, else J1939's where it has one.
Validity meaning(const SignalLayout& layout, RawValues raw_values, std::uint64_t raw) {
  const auto code = std::find_if(layout.codes.begin(), layout.codes.end(),
                                 [raw](const RawCode& named) { return named.raw == raw; });
  if (code != layout.codes.end()) return code->meaning;
  const bool coded = raw_values == RawValues::kJ1939 && layout.type == ValueType::kUnsigned;
  return coded ? j1939_meaning(layout.field.length, raw) : Validity::kValid;
}

}  // namespace

int last_byte(const BitField& field) {
  const int first = field.start_bit / 8;
  if (field.order == ByteOrder::kIntel) return (field.start_bit + field.length - 1) / 8;
  const int in_first = field.start_bit % 8 + 1;
  return field.length <= in_first ? first : first + (field.length - in_first + 7) / 8;
}

std::optional<std::uint64_t> extract(const BitField& field, const Frame& frame) {
  if (last_byte(field) >= std::min<int>(frame.size, kMaxData)) return std::nullopt;
  return field.order == ByteOrder::kIntel ? extract_intel(field, frame) : extract_motorola(field, frame);
}

Validity j1939_meaning(int length, std::uint64_t raw) {
  constexpr std::uint64_t kNoValues = 5;  // 0xFB...0xFF of a top byte
  if (length < 2) return Validity::kValid;
  const int below = length < 12 ? 0 : length - 8;  // bits that do not count
  const std::uint64_t from_top = (low_bits(length) >> below) - (raw >> below);
  if (from_top == 0) return Validity::kNotAvailable;
  return from_top < (length < 8 ? 2 : kNoValues) ? Validity::kErrorValue : Validity::kValid;
}

std::optional<Decoded> read_signal(const SignalLayout& layout, RawValues raw_values, const Frame& frame) {
  for (const Selector& selector : layout.selectors) {
    const auto selected = extract(selector.field, frame);
    if (!selected) return Decoded{};
    const bool here = std::any_of(selector.ranges.begin(), selector.ranges.end(), [&](const auto& range) {
      return *selected >= range.first && *selected <= range.second;
    });
    if (!here) return std::nullopt;
  }
  const auto raw = extract(layout.field, frame);
  if (!raw) return Decoded{};
  if (const Validity what = meaning(layout, raw_values, *raw); what != Validity::kValid)
    return Decoded{what, 0};
  return Decoded{Validity::kValid,
                 number(layout.type, layout.field.length, *raw) * layout.scale + layout.offset};
}

std::uint32_t pgn(std::uint32_t id) {
  const std::uint32_t group = (id >> 8) & 0x3FFFF;
  const bool addressed = ((group >> 8) & 0xFF) < 240;
  return addressed ? group & ~0xFFU : group;
}

bool matches(const MessageMatch& match, const Frame& frame) {
  if (frame.remote || frame.error || frame.extended != match.extended) return false;
  if (!match.j1939) return frame.id == match.id;
  return pgn(frame.id) == pgn(match.id) && (!match.source || *match.source == (frame.id & 0xFF));
}

}  // namespace rigsound::can
