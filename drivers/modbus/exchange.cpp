#include "rigsound/modbus/exchange.hpp"

#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace rigsound::modbus {
namespace {

bool bytes_swapped(WordOrder order) { return order == WordOrder::kBadc || order == WordOrder::kDcba; }
bool words_swapped(WordOrder order) { return order == WordOrder::kCdab || order == WordOrder::kDcba; }

std::uint16_t word(const RegisterRoute& route, std::uint16_t raw) {
  return bytes_swapped(route.order) ? static_cast<std::uint16_t>(raw << 8 | raw >> 8) : raw;
}

/// All words of the value, its first byte on top.
std::uint64_t assembled(const RegisterRoute& route, const std::uint16_t* first) {
  const int words = width(route);
  std::uint64_t bits = 0;
  for (int i = 0; i < words; ++i)
    bits = bits << 16 | word(route, first[words_swapped(route.order) ? words - 1 - i : i]);
  return bits;
}

std::uint64_t masked(std::uint64_t bits, std::uint32_t mask) {
  bits &= mask;
  for (; (mask & 1U) == 0; mask >>= 1) bits >>= 1;
  return bits;
}

template <typename Number, typename Bits>
double as(Bits bits) {
  Number value = 0;
  static_assert(sizeof value == sizeof bits);
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

double raw_value(const RegisterRoute& route, const std::uint16_t* first) {
  if (holds_bits(route.table)) return first[0] != 0 ? 1 : 0;
  const std::uint64_t bits = assembled(route, first);
  if (route.mask != 0) return static_cast<double>(masked(bits, route.mask));
  switch (route.type) {
    case WordType::kInt16:
      return as<std::int16_t>(static_cast<std::uint16_t>(bits));
    case WordType::kInt32:
      return as<std::int32_t>(static_cast<std::uint32_t>(bits));
    case WordType::kFloat32:
      return as<float>(static_cast<std::uint32_t>(bits));
    case WordType::kInt64:
      return as<std::int64_t>(bits);
    case WordType::kFloat64:
      return as<double>(bits);
    case WordType::kUint16:
    case WordType::kUint32:
    case WordType::kUint64:
      break;
  }
  return static_cast<double>(bits);
}

}  // namespace

int width(const RegisterRoute& route) {
  if (holds_bits(route.table)) return 1;
  switch (route.type) {
    case WordType::kInt16:
    case WordType::kUint16:
      return 1;
    case WordType::kInt64:
    case WordType::kUint64:
    case WordType::kFloat64:
      return 4;
    default:
      return 2;
  }
}

double decode(const RegisterRoute& route, const std::uint16_t* first) {
  const double raw = raw_value(route, first);
  if (route.values.empty()) return raw * route.scale + route.offset;
  for (const NamedValue& named : route.values)
    if (raw == static_cast<double>(named.raw)) return named.value;
  return std::numeric_limits<double>::quiet_NaN();
}

void readings(const Exchange& exchange, const std::vector<RegisterRoute>& routes, double time_s,
              std::vector<Reading>& out) {
  const int first = exchange.address, end = first + static_cast<int>(exchange.values.size());
  for (const RegisterRoute& route : routes) {
    if (route.table != exchange.table || route.address < first || route.address + width(route) > end)
      continue;
    const std::uint16_t* const words = &exchange.values[route.address - first];
    const double value = decode(route, words);
    const bool in_table = route.values.empty() || value == value;
    out.push_back({route.target, in_table ? value : raw_value(route, words),
                   in_table ? Validity::kValid : Validity::kOutOfRange, time_s});
  }
}

int manual_base(Table table) {
  constexpr std::array<int, 4> kBases = {40001, 30001, 1, 10001};
  return kBases[static_cast<std::size_t>(table)];
}

std::string describe(Table table, std::uint16_t address) {
  constexpr std::array<const char*, 4> kWords = {"holding", "input", "coil", "discrete"};
  return std::string(kWords[static_cast<std::size_t>(table)]) + " " + std::to_string(address) + " = " +
         std::to_string(manual_base(table) + address);
}

}  // namespace rigsound::modbus
