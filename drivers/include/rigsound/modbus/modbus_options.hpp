// What one Modbus bus of a rig is for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/machine/limits.hpp"
#include "rigsound/machine/signal.hpp"
#include "rigsound/socket/network.hpp"

namespace rigsound::modbus {

constexpr int kPort = 502;  ///< where a Modbus/TCP server listens unless it is told otherwise

enum class Role : std::uint8_t { kServer, kClient };
enum class Transport : std::uint8_t { kTcp, kRtu, kRtuTcp };  ///< kRtuTcp: RTU frames over TCP
enum class Table : std::uint8_t { kHolding, kInput, kCoil, kDiscrete };
/// Tables of single bits; the others hold 16 bit registers.
inline bool holds_bits(Table table) { return table == Table::kCoil || table == Table::kDiscrete; }

enum class WordType : std::uint8_t { kInt16, kUint16, kInt32, kUint32, kFloat32, kInt64, kUint64, kFloat64 };
enum class WordOrder : std::uint8_t { kAbcd, kCdab, kBadc, kDcba };

constexpr Word<Role> kRoles[] = {{"server", Role::kServer}, {"client", Role::kClient}};
constexpr Word<Transport> kTransports[] = {
    {"tcp", Transport::kTcp}, {"rtu", Transport::kRtu}, {"rtu_tcp", Transport::kRtuTcp}};
constexpr Word<Table> kTables[] = {{"holding", Table::kHolding},
                                   {"input", Table::kInput},
                                   {"coil", Table::kCoil},
                                   {"discrete", Table::kDiscrete}};
constexpr Word<WordType> kWordTypes[] = {{"int16", WordType::kInt16},     {"uint16", WordType::kUint16},
                                         {"int32", WordType::kInt32},     {"uint32", WordType::kUint32},
                                         {"float32", WordType::kFloat32}, {"int64", WordType::kInt64},
                                         {"uint64", WordType::kUint64},   {"float64", WordType::kFloat64}};
constexpr Word<WordOrder> kWordOrders[] = {{"ABCD", WordOrder::kAbcd},
                                           {"CDAB", WordOrder::kCdab},
                                           {"BADC", WordOrder::kBadc},
                                           {"DCBA", WordOrder::kDcba}};
constexpr Word<char> kParities[] = {{"none", 'N'}, {"even", 'E'}, {"odd", 'O'}};

/// What a raw value of a table of values stands for.
struct NamedValue {
  std::int64_t raw = 0;
  double value = 0;
};

/// One machine signal in one register or more, in some bits of it, or in a bit.
struct RegisterRoute {
  SignalId target{};
  Table table = Table::kHolding;
  std::uint16_t address = 0;           ///< 0-based, as on the wire
  WordType type = WordType::kUint16;   ///< registers only
  WordOrder order = WordOrder::kAbcd;  ///< byte order inside the value, registers only
  std::uint32_t mask = 0;  ///< registers of whole numbers: the bits that count, moved down to bit 0; 0: all
  std::vector<NamedValue> values;  ///< empty: any; else these raw values and no others
  double scale = 1, offset = 0;    ///< without `values`: value = raw * scale + offset
};

/// Everything but the target and the table of values.
template <class Archive>
void fields(Archive& a, RegisterRoute& o) {
  a("table", o.table, kTables);
  a("address", o.address, Range{0, 65535});
  a("type", o.type, kWordTypes);
  a("word_order", o.order, kWordOrders);
  a("mask", o.mask, Range{0, 4294967295});
  a("scale", o.scale, kBusScales);
  a("offset", o.offset, kBusScales);
}

struct ModbusOptions {
  Role role = Role::kServer;
  Transport transport = Transport::kTcp;
  std::string address = "127.0.0.1:1502";  ///< HOST:PORT or [V6]:PORT; rtu: the serial device
  std::string host = "127.0.0.1";          ///< tcp: taken from `address`
  int port = 1502;                         ///< tcp: taken from `address`
  int unit = 255;                          ///< below 248; 255, on TCP only: any; 0 on TCP only
  double poll_s = 0.1;                     ///< client: time between two readings of a register
  double timeout_s = 0.5;                  ///< client: longest wait for an answer
  double pause_s = 0;                      ///< client: after connecting, and between two requests
  double down_after_s =
      0.3;  ///< client: silence after which its signals are down; no key: from their stale ages
  double master_gone_after_s = 1;  ///< TCP server: how long after the last connection that wrote has
                                   ///< closed its signals are down; 0: never
  std::vector<Network> allow;      ///< server: who may connect; loopback when the rig says nothing
  int baud = 19200;                ///< rtu
  char parity = 'E';               ///< rtu
  int stop_bits = 1;               ///< rtu
  std::vector<RegisterRoute> routes;
};

/// Everything but the networks, the routes and what follows from others.
template <class Archive>
void fields(Archive& a, ModbusOptions& o) {
  a("role", o.role, kRoles);
  a("transport", o.transport, kTransports);
  a("address", o.address);
  a("unit", o.unit, Range{0, 255});
  a("poll_s", o.poll_s, Range{0.005, 60, "s"});
  a("timeout_s", o.timeout_s, Range{0.01, 60, "s"});
  a("pause_s", o.pause_s, Range{0, 1, "s"});
  a("master_gone_after_s", o.master_gone_after_s, Range{0, 3600, "s"});
  a("baud", o.baud, Range{300, 4000000, "bit/s"});
  a("parity", o.parity, kParities);
  a("stop_bits", o.stop_bits, Range{1, 2});
}

}  // namespace rigsound::modbus
