// Writes exchanges to a server, as a simulator would.
#pragma once

#include <memory>
#include <string>

#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {

/// Connects at construction. Errors: DeviceError when the server cannot be reached or goes away.
/// Thread: OFF.
class ModbusWriter {
 public:
  /// `address`: HOST:PORT or [V6]:PORT.
  explicit ModbusWriter(const std::string& address);
  ~ModbusWriter();

  /// Puts the values where the exchange says (holding registers or coils), whether it was written or read.
  /// False when the server refuses.
  bool write(const Exchange& exchange);

 private:
  struct Link;
  std::unique_ptr<Link> link_;
};

}  // namespace rigsound::modbus
