// Serves a simulator on a serial line.
#pragma once

#include <string>

#include "complaints.hpp"
#include "modbus/context.hpp"
#include "modbus/responder.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::modbus {

class RtuServer : public ModbusLink {
 public:
  RtuServer(const ModbusOptions& options, ModbusListener& listener);
  void step() override;

 private:
  void open();
  void garbled(int error);
  void lose(int error);

  ModbusOptions options_;
  ModbusListener& listener_;
  Complaints complaints_;
  Responder responder_;
  Context context_;
  Backoff backoff_;
  std::string last_problem_;
};

}  // namespace rigsound::modbus
