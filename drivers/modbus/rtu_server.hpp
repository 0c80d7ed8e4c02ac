// Serves a simulator on a serial line.
#pragma once

#include <array>

#include "modbus/context.hpp"
#include "modbus/modbus_server.hpp"

namespace rigsound::modbus {

/// libmodbus opens the line and writes the answers. Frames are found here: it knows the length of a request
/// only for functions that it serves, and takes other units' answers for requests.
class RtuServer final : public ModbusServer {
 public:
  RtuServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);
  void step() override;

 private:
  void open();
  void receive();
  bool take_frame();
  void end_of_bytes();
  void obey(std::size_t size);
  bool ours(int unit) const;
  void lose(int error);

  Context context_;
  int silence_ms_;  // that ends a frame of unknown length
  std::array<std::uint8_t, MODBUS_RTU_MAX_ADU_LENGTH> bytes_{};
  std::size_t filled_ = 0;
  bool overflowed_ = false;  // since the line was silent
};

}  // namespace rigsound::modbus
