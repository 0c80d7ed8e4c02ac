// What one Modbus link of a rig is for.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/machine/signal.hpp"

namespace rigsound::modbus {

enum class Role : std::uint8_t { kServer, kClient };
enum class Transport : std::uint8_t { kTcp, kRtu };
enum class Table : std::uint8_t { kHolding, kInput, kCoil, kDiscrete };
enum class WordType : std::uint8_t { kInt16, kUint16, kInt32, kUint32, kFloat32 };
enum class WordOrder : std::uint8_t { kAbcd, kCdab, kBadc, kDcba };

/// One machine signal in a register (or two) or a bit.
struct RegisterRoute {
  SignalId target{};
  Table table = Table::kHolding;
  std::uint16_t address = 0;           ///< 0-based, as on the wire
  WordType type = WordType::kUint16;   ///< registers only
  WordOrder order = WordOrder::kAbcd;  ///< byte order inside the value, registers only
  double scale = 1, offset = 0;        ///< value = raw * scale + offset
};

/// An IPv4 or IPv6 network that may connect, as written: "127.0.0.0/8", "::1/128", "192.168.1.5".
struct Network {
  std::string text;
  std::vector<std::uint8_t> address;  ///< 4 or 16 bytes, network byte order, host bits zero
  int prefix = 0;                     ///< bits that must match
};

struct ModbusOptions {
  Role role = Role::kServer;
  Transport transport = Transport::kTcp;
  std::string address = "127.0.0.1:1502";  ///< tcp: HOST:PORT or [V6]:PORT; rtu: the serial device
  std::string host = "127.0.0.1";          ///< tcp: taken from `address`
  int port = 1502;                         ///< tcp: taken from `address`
  int unit = 255;                          ///< 1...247; 255 on TCP: any
  double poll_s = 0.1;                     ///< client: time between two readings of a register
  double timeout_s = 0.5;                  ///< client: longest wait for an answer
  std::vector<Network> allow;              ///< server: who may connect; loopback when the rig says nothing
  int baud = 19200;                        ///< rtu
  char parity = 'E';                       ///< rtu: N, E, O
  int stop_bits = 1;                       ///< rtu: 1, 2
  std::vector<RegisterRoute> routes;
};

}  // namespace rigsound::modbus
