// What a server does with one whole request, whatever carried it.
#pragma once

#include <modbus.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "modbus/modbus_bus.hpp"
#include "modbus/register_file.hpp"

namespace rigsound::modbus {

class ModbusServer : public ModbusBus {
 protected:
  ModbusServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);

  /// `adu`, `size`: a request as modbus_reply wants it, with its checksum if the transport has one;
  /// `pdu_size` bytes from the function code on. Sends the answer, or the refusal, through `context`, and
  /// counts it. False: it could not be sent, errno says why.
  bool respond(modbus_t* context, const std::uint8_t* adu, int size, std::size_t pdu_size,
               const std::string& peer);

 private:
  RegisterFile registers_;
};

}  // namespace rigsound::modbus
