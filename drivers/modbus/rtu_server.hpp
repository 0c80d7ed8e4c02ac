// Serves a simulator on a serial line.
#pragma once

#include "modbus/context.hpp"
#include "modbus/modbus_server.hpp"

namespace rigsound::modbus {

class RtuServer final : public ModbusServer {
 public:
  RtuServer(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);
  void step() override;

 private:
  void open();
  void drop_bad_frame(int error);
  void lose(int error);

  Context context_;
};

}  // namespace rigsound::modbus
