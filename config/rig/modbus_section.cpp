#include "rig/network.hpp"
#include "rig/sections.hpp"
#include "rigsound/socket/host_port.hpp"

namespace rigsound::config {
namespace {

using namespace modbus;

constexpr int kDefaultPort = 502;

constexpr Word<Role> kRoles[] = {{"server", Role::kServer}, {"client", Role::kClient}};
constexpr Word<Transport> kTransports[] = {{"tcp", Transport::kTcp}, {"rtu", Transport::kRtu}};
constexpr Word<Table> kTables[] = {{"holding", Table::kHolding},
                                   {"input", Table::kInput},
                                   {"coil", Table::kCoil},
                                   {"discrete", Table::kDiscrete}};
constexpr Word<WordType> kTypes[] = {{"int16", WordType::kInt16},
                                     {"uint16", WordType::kUint16},
                                     {"int32", WordType::kInt32},
                                     {"uint32", WordType::kUint32},
                                     {"float32", WordType::kFloat32}};
constexpr Word<WordOrder> kOrders[] = {{"ABCD", WordOrder::kAbcd},
                                       {"CDAB", WordOrder::kCdab},
                                       {"BADC", WordOrder::kBadc},
                                       {"DCBA", WordOrder::kDcba}};
constexpr Word<char> kParities[] = {{"none", 'N'}, {"even", 'E'}, {"odd", 'O'}};

bool is_bit(Table table) { return table == Table::kCoil || table == Table::kDiscrete; }
int words(WordType type) { return type == WordType::kInt16 || type == WordType::kUint16 ? 1 : 2; }

RegisterRoute read_register(TomlTable table, SignalId id) {
  RegisterRoute route;
  route.target = id;
  route.table = table.word("table", route.table, kTables);
  table.require("address", "a register or bit counted from 0");
  route.address = static_cast<std::uint16_t>(table.integer("address", 0, 0, 65535));
  if (is_bit(route.table) && (table.has("type") || table.has("word_order")))
    table.fail(table.has("type") ? "type" : "word_order", "does not go with a bit, expected none");
  route.type = table.word("type", route.type, kTypes);
  route.order = table.word("word_order", route.order, kOrders);
  if (!is_bit(route.table) && route.address + words(route.type) > 65536)
    table.fail("address", "leaves no room for two registers, expected at most 65534");
  route.scale = table.number("scale", route.scale, -1e9, 1e9);
  if (route.scale == 0) table.fail("scale", "is 0, expected any other number");
  route.offset = table.number("offset", route.offset, -1e9, 1e9);
  table.refuse_unknown();
  return route;
}

void read_tcp(TomlTable& table, ModbusOptions& options) {
  options.address = table.text("address", options.address);
  const auto where = parse_host_port(options.address, kDefaultPort);
  if (!where)
    table.fail("address", "\"" + options.address + "\" is no address, expected HOST:PORT or [V6]:PORT");
  options.host = where->host;
  options.port = where->port;
}

void read_rtu(TomlTable& table, ModbusOptions& options) {
  options.address = table.required_text("address", "the serial device, e.g. \"/dev/ttyUSB0\"");
  options.host.clear();
  options.port = 0;
  options.baud = table.integer("baud", options.baud, 300, 4000000);
  options.parity = table.word("parity", options.parity, kParities);
  options.stop_bits = table.integer("stop_bits", options.stop_bits, 1, 2);
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

ModbusOptions read_modbus(TomlTable table, const std::vector<BoomOptions>& booms) {
  ModbusOptions options;
  options.role = table.word("role", options.role, kRoles);
  options.transport = table.word("transport", options.transport, kTransports);
  if (options.transport == Transport::kTcp)
    read_tcp(table, options);
  else
    read_rtu(table, options);
  options.unit = table.integer("unit", options.transport == Transport::kTcp ? 255 : 1, 1, 255);
  if (options.unit > 247 && (options.unit != 255 || options.transport == Transport::kRtu))
    table.fail("unit", std::to_string(options.unit) + " is no unit, expected 1 to 247, or 255 on TCP");
  options.poll_s = table.number("poll_ms", options.poll_s * 1000, 5, 60000) / 1000;
  options.timeout_s = table.number("timeout_ms", options.timeout_s * 1000, 10, 60000) / 1000;
  read_allow(table, options);
  read_signals(table.table("signals"), booms,
               [&options](TomlTable& signals, const std::string& key, SignalId id) {
                 options.routes.push_back(read_register(signals.table(key), id));
               });
  table.refuse_unknown();
  return options;
}

}  // namespace rigsound::config
