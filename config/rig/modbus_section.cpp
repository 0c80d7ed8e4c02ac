#include "rig/network.hpp"
#include "rig/sections.hpp"
#include "rigsound/modbus/exchange.hpp"
#include "rigsound/socket/host_port.hpp"
#include "toml/toml_reader.hpp"

namespace rigsound::config {
namespace {

using namespace modbus;

constexpr int kDefaultPort = 502;

RegisterRoute read_register(TomlTable table, SignalId id) {
  RegisterRoute route;
  route.target = id;
  table.require("address", "a register or bit counted from 0");
  read(table, route);
  if (holds_bits(route.table) && (table.has("type") || table.has("word_order")))
    table.fail(table.has("type") ? "type" : "word_order", "does not go with a bit, expected none");
  if (route.address + width(route) > 65536)
    table.fail("address", "leaves no room for two registers, expected at most 65534");
  if (route.scale == 0) table.fail("scale", "is 0, expected any other number");
  table.refuse_unknown();
  return route;
}

void refuse_serial_keys(const TomlTable& table) {
  for (const char* key : {"baud", "parity", "stop_bits"})
    if (table.has(key)) table.fail(key, "goes with transport = \"rtu\" only, expected none");
}

void take_host(const TomlTable& table, ModbusOptions& options) {
  const auto where = parse_host_port(options.address, kDefaultPort);
  if (!where)
    table.fail("address", "\"" + options.address + "\" is no address, expected HOST:PORT or [V6]:PORT");
  options.host = where->host;
  options.port = where->port;
}

void require_device(TomlTable& table, ModbusOptions& options) {
  table.required_text("address", "the serial device, e.g. \"/dev/ttyUSB0\"");
  options.host.clear();
  options.port = 0;
}

void read_allow(TomlTable& table, ModbusOptions& options) {
  const bool given = table.has("allow");
  std::vector<std::string> texts = table.texts("allow");
  if (!given) texts = {"127.0.0.0/8", "::1"};
  for (const std::string& text : texts) {
    const auto network = parse_network(text);
    if (!network)
      table.fail("allow", "\"" + text +
                              "\" is no network, expected one like \"192.168.1.0/24\" with no bits after it");
    options.allow.push_back(*network);
  }
}

}  // namespace

ModbusRead read_modbus(TomlTable table, const std::vector<BoomOptions>& booms) {
  ModbusOptions options;
  std::vector<std::string> doubts;
  if (table.word("transport", options.transport, kTransports) == Transport::kRtu) options.unit = 1;
  read(table, options);
  if (options.transport == Transport::kTcp)
    take_host(table, options);
  else
    require_device(table, options);
  if (options.unit > 247 && (options.unit != 255 || options.transport == Transport::kRtu))
    table.fail("unit", std::to_string(options.unit) + " is no unit, expected 1 to 247, or 255 on TCP");
  read_allow(table, options);
  read_signals(table.table("signals"), booms,
               [&options](TomlTable& signals, const std::string& key, SignalId id) {
                 options.routes.push_back(read_register(signals.table(key), id));
               });
  table.refuse_unknown();
  if (options.transport == Transport::kTcp) refuse_serial_keys(table);
  return {std::move(options), std::move(doubts)};
}

}  // namespace rigsound::config
