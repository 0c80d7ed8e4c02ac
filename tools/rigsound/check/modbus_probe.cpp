#include "check/modbus_probe.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rigsound/device_error.hpp"
#include "rigsound/modbus/modbus_bus.hpp"

namespace rigsound::tools {
namespace {

using modbus::Exchange;
using modbus::RegisterRoute;
using modbus::WordOrder;

constexpr std::pair<WordOrder, std::string_view> kOrders[] = {{WordOrder::kAbcd, "ABCD"},
                                                              {WordOrder::kCdab, "CDAB"},
                                                              {WordOrder::kBadc, "BADC"},
                                                              {WordOrder::kDcba, "DCBA"}};

/// Keeps what a device answers.
class Answers : public BusListener, public modbus::ModbusTap {
 public:
  void readings(const Reading*, std::size_t count) override { told_ += count; }
  void traffic(const Exchange* first, std::size_t count) override {
    exchanges_.insert(exchanges_.end(), first, first + count);
  }
  void up() override {}
  void down(const std::string& why) override { throw DeviceError(why); }
  // Before the first answer it says why there is none; later, which register the device does not have.
  void notice(const std::string& text) override {
    if (exchanges_.empty() && told_ == 0) throw DeviceError(text);
    fmt::print(stderr, "{}\n", text);
  }

  /// Values told so far, or said not to be there.
  std::size_t told() const { return told_; }

  /// The route's first register or bit, or nullptr when the device has none.
  const std::uint16_t* find(const RegisterRoute& route) const {
    for (const Exchange& e : exchanges_) {
      const int offset = route.address - e.address;
      const bool inside = offset >= 0 && offset + width(route) <= static_cast<int>(e.values.size());
      if (e.table == route.table && inside) return &e.values[static_cast<std::size_t>(offset)];
    }
    return nullptr;
  }

 private:
  std::vector<Exchange> exchanges_;
  std::size_t told_ = 0;
};

void print_orders(RegisterRoute route, const std::uint16_t* words) {
  const WordOrder chosen = route.order;
  const std::string_view unit = info(route.target.signal).unit;
  for (const auto& [order, name] : kOrders) {
    const bool same_as_before = width(route) == 1 && (order == WordOrder::kCdab || order == WordOrder::kDcba);
    if (same_as_before) continue;  // one register has only two bytes to swap
    route.order = order;
    fmt::print("    {}  {:g} {}{}\n", name, modbus::decode(route, words), unit,
               order == chosen ? "  <- the rig's" : "");
  }
}

void print_value(const config::Rig& rig, const RegisterRoute& route, const std::uint16_t* words) {
  fmt::print("  {:<20} {}", config::signal_label(rig, route.target),
             modbus::describe(route.table, route.address));
  if (words == nullptr) return fmt::print("  not there\n");
  if (holds_bits(route.table)) return fmt::print("  {}\n", words[0] != 0 ? "on" : "off");
  fmt::print("  {:04X}{}\n", words[0], width(route) == 2 ? fmt::format(" {:04X}", words[1]) : "");
  print_orders(route, words);
}

}  // namespace

void probe_modbus(const config::Rig& rig) {
  for (modbus::ModbusOptions options : rig.modbus) {
    options.role = modbus::Role::kClient;
    Answers answers;
    const auto bus = modbus::make_bus(options, answers, &answers);
    while (answers.told() < options.routes.size()) bus->step();
    fmt::print("probe {}\n", options.address);
    for (const RegisterRoute& route : options.routes) print_value(rig, route, answers.find(route));
  }
}

}  // namespace rigsound::tools
