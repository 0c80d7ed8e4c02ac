#include "check/modbus_probe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/device_error.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/modbus/probe.hpp"

namespace rigsound::tools {
namespace {

using modbus::RegisterRoute;
using modbus::WordOrder;

/// What the machine could say: a value in the signal's range that is not nothing.
bool plausible(const RegisterRoute& route, const std::vector<std::uint16_t>& words) {
  constexpr double kLeast = 1e-6;  // a float whose words are swapped is often smaller
  const double value = modbus::decode(route, words.data());
  return info(route.target.signal).takes(value) && std::fabs(value) > kLeast;
}

void print_orders(RegisterRoute route, const std::vector<std::uint16_t>& words) {
  const WordOrder chosen = route.order;
  const bool chosen_is_plausible = plausible(route, words);
  const std::string_view unit = info(route.target.signal).unit;
  for (const auto& [name, order] : modbus::kWordOrders) {
    const bool same_as_before = width(route) == 1 && (order == WordOrder::kCdab || order == WordOrder::kDcba);
    if (same_as_before) continue;  // one register has only two bytes to swap
    route.order = order;
    const bool likely = order != chosen && !chosen_is_plausible && plausible(route, words);
    fmt::print("    {}  {:g} {}{}\n", name, modbus::decode(route, words.data()), unit,
               order == chosen ? "  <- the rig's"
               : likely        ? fmt::format("  <- likely: word_order = \"{}\"?", name)
                               : "");
  }
}

void print_value(const config::Rig& rig, const RegisterRoute& route, const modbus::Probed& probed) {
  fmt::print("  {:<20} {}", config::signal_label(rig, route.target),
             modbus::describe(route.table, route.address));
  if (probed.words.empty()) {
    const int base = modbus::manual_base(route.table);
    const bool manual = base > 1 && route.address >= base;
    return fmt::print(
        "  cannot be read: {}{}\n", probed.problem,
        manual ? fmt::format("; addresses count from 0: address = {}?", route.address - base) : "");
  }
  if (holds_bits(route.table)) return fmt::print("  {}\n", probed.words[0] != 0 ? "on" : "off");
  for (const std::uint16_t word : probed.words) fmt::print("  {:04X}", word);
  fmt::print("\n");
  if (route.mask == 0 && route.values.empty()) return print_orders(route, probed.words);
  const double value = modbus::decode(route, probed.words.data());
  const std::string_view word = value_word(route.target.signal, value);
  if (std::isnan(value)) return fmt::print("    a raw value that is not among its values\n");
  fmt::print("    {:g}{}{}\n", value, word.empty() ? "" : " ", word);
}

/// Returns how many signals cannot be read.
std::size_t print_link(const config::Rig& rig, const modbus::ModbusOptions& options) {
  const std::vector<modbus::Probed> found = modbus::probe(options);
  fmt::print("probe {} unit {}\n", options.address, options.unit);
  std::size_t missing = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    print_value(rig, options.routes[i], found[i]);
    missing += found[i].words.empty() ? 1 : 0;
  }
  return missing;
}

}  // namespace

void probe_modbus(const config::Rig& rig) {
  std::size_t missing = 0;
  std::string unreachable;
  for (const modbus::ModbusOptions& options : rig.modbus) {
    try {
      missing += print_link(rig, options);
    } catch (const DeviceError& error) {
      unreachable += (unreachable.empty() ? "modbus " : "; modbus ") + options.address + ": " + error.what();
    }
  }
  if (!unreachable.empty()) throw DeviceError(unreachable);
  if (missing > 0) throw DeviceError(fmt::format("{} signals cannot be read", missing));
}

}  // namespace rigsound::tools
