#include <algorithm>
#include <filesystem>

#include "rigsound/number_of.hpp"

#include "rig/allow.hpp"
#include "rig/sections.hpp"
#include "rigsound/file/file_kind.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/socket/host_port.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

using namespace modbus;

constexpr Range kBits{0, 31};

bool is_float(WordType type) { return type == WordType::kFloat32 || type == WordType::kFloat64; }

/// `bit = 3` is `mask = 8`.
void read_bit(TomlTable& table, RegisterRoute& route) {
  if (!table.has("bit")) return;
  if (route.mask != 0) table.fail("bit", "does not go with a mask, expected one of them");
  route.mask = 1U << static_cast<unsigned>(table.integer("bit", 0, kBits));
}

double value_of_word(const TomlTable& table, const std::string& key, const std::string& word, Signal s) {
  const SignalInfo& signal = info(s);
  for (double value = signal.min; signal.kind == SignalKind::kWord && value <= signal.max; ++value)
    if (value_word(s, value) == word) return value;
  std::string words(signal.words);
  std::replace(words.begin(), words.end(), '|', ',');
  table.fail(key, "\"" + word + "\" is no value of " + std::string(signal.name) + ", expected " +
                      (words.empty() ? "a number" : "one of " + words));
}

/// `values = { 0 = "off", 3 = "on" }`: raw values, and what they stand for.
void read_values(TomlTable table, RegisterRoute& route) {
  const SignalInfo& signal = info(route.target.signal);
  for (const std::string& key : table.keys()) {
    NamedValue named;
    const auto raw = number_of<decltype(named.raw)>(key);
    if (!raw) table.fail(key, "is no raw value, expected a whole number");
    named.raw = *raw;
    if (table.is_text(key)) {
      named.value = value_of_word(table, key, table.text(key, {}), route.target.signal);
    } else {
      const bool zero = signal.kind == SignalKind::kNumberOrZero;
      const Range range{signal.min, signal.max, "", 0, zero};
      named.value = table.number(key, 0, range);
    }
    route.values.push_back(named);
  }
}

RegisterRoute read_register(TomlTable table, SignalId id) {
  RegisterRoute route;
  route.target = id;
  table.require("address", "a register or bit counted from 0");
  read(table, route);
  read_bit(table, route);
  read_values(table.table("values"), route);
  for (const char* key : {"type", "word_order", "mask", "bit"})
    if (holds_bits(route.table) && table.has(key)) table.fail(key, "does not go with a bit, expected none");
  if (route.mask != 0 && is_float(route.type))
    table.fail(table.has("bit") ? "bit" : "mask", "does not go with a float, expected a whole number's type");
  if (route.address + width(route) > 65536)
    table.fail("address",
               "leaves no room for its registers, expected at most " + std::to_string(65536 - width(route)));
  if (route.scale == 0) table.fail("scale", "is 0, expected any other number");
  if (!route.values.empty() && (table.has("scale") || table.has("offset")))
    table.fail(table.has("scale") ? "scale" : "offset", "does not go with values, expected none");
  table.refuse_unknown();
  return route;
}

/// A manual's number that was taken for an address.
void doubt_address(const TomlTable& table, const std::string& key, const RegisterRoute& route,
                   std::vector<std::string>& doubts) {
  const int base = manual_base(route.table);
  if (base == 1 || route.address < base || route.address > base + 9998) return;
  doubts.push_back(table.file() + ":" + std::to_string(table.line_of(key)) + ": " + table.path_of(key) +
                   ": address " + std::to_string(route.address) + " counts from 0, so it is " +
                   describe(route.table, route.address) +
                   ": address = " + std::to_string(route.address - base) + "?");
}

void refuse_serial_keys(const TomlTable& table) {
  for (const char* key : {"baud", "parity", "stop_bits"})
    if (table.has(key)) table.fail(key, "goes with transport = \"rtu\" only, expected none");
}

void take_host(const TomlTable& table, ModbusOptions& options) {
  const auto where = parse_host_port(options.address, kPort);
  if (!where)
    table.fail("address", "\"" + options.address + "\" is no address, expected HOST:PORT or [V6]:PORT");
  options.host = where->host;
  options.port = where->port;
}

void require_device(TomlTable& table, ModbusOptions& options) {
  table.required_text("address", "the serial device, e.g. \"/dev/ttyUSB0\"");
  std::error_code error;
  const std::filesystem::file_type type = std::filesystem::status(options.address, error).type();
  if (!kind_word(type).empty() && type != std::filesystem::file_type::character)
    table.fail("address", "\"" + options.address + "\" is " + std::string(kind_word(type)) +
                              ", expected a serial device");
  options.host.clear();
  options.port = 0;
}

/// 255 stands for any on Modbus/TCP; 0 is a broadcast where frames are RTU, which nobody answers.
void require_unit(const TomlTable& table, const ModbusOptions& options) {
  const bool rtu_frames = options.transport != Transport::kTcp;
  if (options.unit > 247 && (options.unit != 255 || rtu_frames))
    table.fail("unit", std::to_string(options.unit) + " is no unit, expected 1 to 247, or 0 or 255 on TCP");
  if (options.unit == 0 && rtu_frames)
    table.fail("unit", "0 is a broadcast on RTU, which nobody answers, expected 1 to 247");
}

/// A server that listens to other machines and lets none of them in.
bool hears_nobody(const TomlTable& table, const ModbusOptions& options) {
  const bool loopback =
      options.host == "localhost" || options.host == "::1" || options.host.compare(0, 4, "127.") == 0;
  return options.role == Role::kServer && options.transport != Transport::kRtu && !loopback &&
         !table.has("allow");
}

}  // namespace

ModbusRead read_modbus(TomlTable table, const std::vector<BoomOptions>& booms) {
  ModbusOptions options;
  std::vector<std::string> doubts;
  if (table.word("transport", options.transport, kTransports) != Transport::kTcp) options.unit = 1;
  read(table, options);
  if (options.transport != Transport::kRtu)
    take_host(table, options);
  else
    require_device(table, options);
  require_unit(table, options);
  options.allow = read_allow(table);
  if (hears_nobody(table, options))
    doubts.push_back(table.file() + ":" + std::to_string(table.line_of("address")) + ": " +
                     table.path_of("address") + ": listens to " + options.host +
                     ", but without allow only this machine may connect: allow = [\"192.168.1.0/24\"]?");
  read_signals(table.table("signals"), booms, [&](TomlTable& signals, const std::string& key, SignalId id) {
    options.routes.push_back(read_register(signals.table(key), id));
    doubt_address(signals, key, options.routes.back(), doubts);
  });
  table.refuse_unknown();
  if (options.transport != Transport::kRtu) refuse_serial_keys(table);
  return {std::move(options), std::move(doubts)};
}

}  // namespace rigsound::config
