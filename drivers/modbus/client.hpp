// Asks a device for every register of the rig, once a poll.
#pragma once

#include <cstdint>
#include <vector>

#include "modbus/context.hpp"
#include "modbus/modbus_bus.hpp"
#include "modbus/poll_plan.hpp"

namespace rigsound::modbus {

class Client final : public ModbusBus {
 public:
  Client(const ModbusOptions& options, BusListener& listener, ModbusTap* tap);
  void step() override;

 private:
  void connect();
  void poll();
  bool read(const PollRequest& request, Exchange& answer);
  void report_error_value(const PollRequest& request);
  void lose(int error);

  std::vector<PollRequest> plan_;
  Context context_;
  bool answered_ = false;  // since the connection was made: only an answer shows that somebody is there
  std::int64_t next_poll_ms_ = 0;
};

}  // namespace rigsound::modbus
