// What a server does with one whole request, whatever carried it.
#pragma once

#include <modbus.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "modbus/modbus_bus.hpp"
#include "modbus/register_file.hpp"

namespace rigsound::modbus {

class ModbusServer : public ModbusBus {
 protected:
  /// What became of a request.
  enum class Reply : std::uint8_t {
    kSent,    ///< an answer, or a refusal
    kNone,    ///< a broadcast, or another unit's on a serial line
    kFailed,  ///< it could not be sent, errno says why
  };

  ModbusServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);

  /// `adu`, `size`: a request as modbus_reply wants it, with its checksum if the transport has one;
  /// `pdu_size` bytes from the function code on. Sends the answer, or the refusal, through `context`, and
  /// counts it.
  Reply respond(modbus_t* context, const std::uint8_t* adu, int size, std::size_t pdu_size,
                const std::string& peer);

  std::uint64_t writes() const { return writes_; }  ///< requests that wrote, so far
  const ModbusOptions& options() const { return options_; }

 private:
  std::optional<Refusal> carry_out(const Request& request, int unit, Exchange& change) const;
  void warn_refused(const Request& request, int function, Refusal refusal, const std::string& peer);

  ModbusOptions options_;
  RegisterFile registers_;
  std::uint64_t writes_ = 0;
};

}  // namespace rigsound::modbus
