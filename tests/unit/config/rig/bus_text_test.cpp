#include "rigsound/config/bus_text.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace rigsound;

TEST_CASE("a bus that is told anything else has another text") {
  can::CanOptions bus;
  bus.interface = "can0";
  bus.routes.resize(1);
  std::set<std::string> texts = {config::bus_text(bus)};
  CHECK(config::bus_text(bus) == config::bus_text(can::CanOptions(bus)));
  const auto differs = [&](auto change) {
    can::CanOptions other = bus;
    change(other, other.routes[0]);
    CHECK(texts.insert(config::bus_text(other)).second);
  };
  differs([](auto& b, auto&) { b.interface = "can1"; });
  differs([](auto& b, auto&) { b.fd = true; });
  differs([](auto& b, auto&) { b.routes.emplace_back(); });
  differs([](auto&, auto& r) { r.target = {Signal::kRodCount, 0}; });
  differs([](auto&, auto& r) { r.target = {Signal::kEngineRpm, 1}; });
  differs([](auto&, auto& r) { r.match.id = 7; });
  differs([](auto&, auto& r) { r.match.extended = true; });
  differs([](auto&, auto& r) { r.match.j1939 = true; });
  differs([](auto&, auto& r) { r.match.source = 0; });
  differs([](auto&, auto& r) { r.layout.field.start_bit = 8; });
  differs([](auto&, auto& r) { r.layout.field.order = can::ByteOrder::kMotorola; });
  differs([](auto&, auto& r) { r.layout.type = can::ValueType::kSigned; });
  differs([](auto&, auto& r) { r.layout.scale = 0.1 + 1e-15; });
  differs([](auto&, auto& r) { r.layout.offset = 1; });
  differs([](auto&, auto& r) { r.layout.selectors = {{{}, {{1, 2}}}}; });
  differs([](auto&, auto& r) { r.layout.codes = {{3, Validity::kErrorValue}}; });

  modbus::ModbusOptions section;
  section.routes.resize(1);
  texts = {config::bus_text(modbus::Line{section})};
  const auto other_line = [&](auto change) {
    modbus::Line line = {section};
    change(line, line[0].routes[0]);
    CHECK(texts.insert(config::bus_text(line)).second);
  };
  other_line([](auto& l, auto&) { l.push_back(l[0]); });
  other_line([](auto& l, auto&) { l[0].unit = 3; });
  other_line([](auto& l, auto&) { l[0].allow = {{"10.0.0.0/8", {10, 0, 0, 0}, 8}}; });
  other_line([](auto& l, auto&) { l[0].down_after_s = 9; });
  other_line([](auto& l, auto&) { l[0].master_gone_after_s = 0; });
  other_line([](auto&, auto& r) { r.mask = 4; });
  other_line([](auto&, auto& r) { r.values = {{1, 2}}; });
  other_line([](auto&, auto& r) { r.address = 4; });

  udp::UdpOptions input;
  const std::string plain = config::bus_text(input);
  input.routes.push_back({{Signal::kRock, 0}, "rock", ""});
  CHECK(config::bus_text(input) != plain);
}
