#include "rigsound/modbus/exchange.hpp"

#include <array>
#include <cstring>
#include <utility>

namespace rigsound::modbus {
namespace {

bool bytes_swapped(WordOrder order) { return order == WordOrder::kBadc || order == WordOrder::kDcba; }
bool words_swapped(WordOrder order) { return order == WordOrder::kCdab || order == WordOrder::kDcba; }

std::uint16_t word(const RegisterRoute& route, std::uint16_t raw) {
  return bytes_swapped(route.order) ? static_cast<std::uint16_t>(raw << 8 | raw >> 8) : raw;
}

std::uint32_t double_word(const RegisterRoute& route, const std::uint16_t* first) {
  std::uint32_t high = word(route, first[0]), low = word(route, first[1]);
  if (words_swapped(route.order)) std::swap(high, low);
  return high << 16 | low;
}

double raw_value(const RegisterRoute& route, const std::uint16_t* first) {
  if (holds_bits(route.table)) return first[0] != 0 ? 1 : 0;
  switch (route.type) {
    case WordType::kInt16:
      return static_cast<std::int16_t>(word(route, first[0]));
    case WordType::kUint16:
      return word(route, first[0]);
    case WordType::kInt32:
      return static_cast<std::int32_t>(double_word(route, first));
    case WordType::kUint32:
      return double_word(route, first);
    case WordType::kFloat32:
      break;
  }
  const std::uint32_t bits = double_word(route, first);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace

int width(const RegisterRoute& route) {
  const bool one =
      holds_bits(route.table) || route.type == WordType::kInt16 || route.type == WordType::kUint16;
  return one ? 1 : 2;
}

double decode(const RegisterRoute& route, const std::uint16_t* first) {
  return raw_value(route, first) * route.scale + route.offset;
}

void readings(const Exchange& exchange, const std::vector<RegisterRoute>& routes, double time_s,
              std::vector<Reading>& out) {
  const int first = exchange.address, end = first + static_cast<int>(exchange.values.size());
  for (const RegisterRoute& route : routes) {
    if (route.table != exchange.table || route.address < first || route.address + width(route) > end)
      continue;
    out.push_back(
        {route.target, decode(route, &exchange.values[route.address - first]), Validity::kValid, time_s});
  }
}

std::string describe(Table table, std::uint16_t address) {
  struct Name {
    const char* word;
    int base;
  };
  constexpr std::array<Name, 4> kNames = {
      {{"holding", 40001}, {"input", 30001}, {"coil", 1}, {"discrete", 10001}}};
  const Name& name = kNames[static_cast<std::size_t>(table)];
  return std::string(name.word) + " " + std::to_string(address) + " = " + std::to_string(name.base + address);
}

}  // namespace rigsound::modbus
