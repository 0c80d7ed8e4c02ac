#include "rigsound/config/bus_text.hpp"

#include <cstdio>
#include <string_view>

#include "rigsound/machine/fields.hpp"

namespace rigsound::config {
namespace {

/// An archive of rigsound/machine/fields.hpp, and of what the lists leave out.
class Text {
 public:
  explicit Text(const char* kind) : text_(kind) {}

  void add(double x) {
    char digits[32];
    std::snprintf(digits, sizeof digits, " %.17g", x);
    text_ += digits;
  }
  void add(const std::string& word) { text_ += " " + std::to_string(word.size()) + ":" + word; }
  void add(SignalId id) {
    add(static_cast<double>(id.signal));
    add(static_cast<double>(id.boom));
  }
  void add(const can::BitField& field) {
    add(static_cast<double>(field.start_bit));
    add(static_cast<double>(field.length));
    add(static_cast<double>(field.order));
  }
  void add(const std::vector<Network>& networks) {
    for (const Network& network : networks) add(network.text);
  }

  template <class Number>
  void operator()(const char*, const Number& x, const Range&) {
    add(static_cast<double>(x));
  }
  template <class E, std::size_t N>
  void operator()(const char*, const E& value, const Word<E> (&)[N]) {
    add(static_cast<double>(value));
  }
  void operator()(const char*, const std::string& word) { add(word); }
  void operator()(const char*, const bool& on) { add(on ? 1.0 : 0.0); }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add(Text& text, const can::SignalLayout& layout) {
  text.add(layout.field);
  text.add(static_cast<double>(layout.type));
  text.add(layout.scale);
  text.add(layout.offset);
  for (const can::Selector& selector : layout.selectors) {
    text.add(selector.field);
    for (const auto& [first, last] : selector.ranges)
      text.add(std::to_string(first) + "-" + std::to_string(last));
  }
  for (const can::RawCode& code : layout.codes)
    text.add(std::to_string(code.raw) + "=" + std::to_string(static_cast<int>(code.meaning)));
}

void add(Text& text, const can::SignalRoute& route) {
  text.add(route.target);
  text.add(static_cast<double>(route.match.id));
  text.add(route.match.extended ? "extended" : "standard");
  text.add(route.match.j1939 ? "j1939" : "id");
  text.add(route.match.source ? std::to_string(*route.match.source) : "any");
  add(text, route.layout);
}

void add(Text& text, const modbus::ModbusOptions& section) {
  visit(text, section);
  text.add(section.down_after_s);
  text.add(section.allow);
  for (const modbus::RegisterRoute& route : section.routes) {
    text.add(route.target);
    visit(text, route);
    for (const modbus::NamedValue& named : route.values) {
      text.add(std::to_string(named.raw));
      text.add(named.value);
    }
  }
}

void add(Text& text, const std::vector<udp::NameRoute>& routes) {
  for (const udp::NameRoute& route : routes) {
    text.add(route.target);
    text.add(route.name);
    text.add(route.alias);
  }
}

}  // namespace

std::string bus_text(const can::CanOptions& bus) {
  Text text("can");
  visit(text, bus);
  for (const can::SignalRoute& route : bus.routes) add(text, route);
  return text.text();
}

std::string bus_text(const modbus::Line& line) {
  Text text("modbus");
  for (const modbus::ModbusOptions& section : line) add(text, section);
  return text.text();
}

std::string bus_text(const udp::UdpOptions& input) {
  Text text("udp");
  visit(text, input);
  text.add(input.allow);
  add(text, input.routes);
  return text.text();
}

std::string bus_text(const osc::OscOptions& osc) {
  Text text("osc");
  text.add(osc.address);
  text.add(osc.allow);
  add(text, osc.routes);
  for (const std::string& boom : osc.booms) text.add(boom);
  return text.text();
}

}  // namespace rigsound::config
