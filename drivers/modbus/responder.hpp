// What a server does with one whole request, whatever carried it.
#pragma once

#include <modbus.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "complaints.hpp"
#include "modbus/register_file.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::modbus {

class Responder {
 public:
  Responder(const ModbusOptions& options, ModbusListener& listener, Complaints& complaints);

  enum class Outcome : std::uint8_t { kAnswered, kRefused, kNotSent };

  /// `adu`, `size`: a request as modbus_reply wants it, with its checksum if the transport has one;
  /// `pdu_size` bytes from the function code on. Sends the answer, or the refusal, through `context`.
  Outcome respond(modbus_t* context, const std::uint8_t* adu, int size, std::size_t pdu_size,
                  const std::string& peer);

 private:
  void tell(const Exchange& change);

  ModbusOptions options_;
  ModbusListener& listener_;
  Complaints& complaints_;
  RegisterFile registers_;
};

}  // namespace rigsound::modbus
