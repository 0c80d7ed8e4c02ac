// Asks a device for every register of the rig, once a poll.
#pragma once

#include <string>
#include <vector>

#include "complaints.hpp"
#include "modbus/context.hpp"
#include "modbus/poll_plan.hpp"
#include "rigsound/modbus/modbus_link.hpp"

namespace rigsound::modbus {

class Client : public ModbusLink {
 public:
  Client(const ModbusOptions& options, ModbusListener& listener);
  void step() override;

 private:
  void connect();
  void poll();
  bool ask(const PollRequest& request, Exchange& answer);
  void doubt(const PollRequest& request);
  void lose(int error);

  ModbusOptions options_;
  ModbusListener& listener_;
  Complaints complaints_;
  std::vector<PollRequest> plan_;
  Context context_;
  Backoff backoff_;
  bool answered_ = false;  // since the connection was made: only an answer shows that somebody is there
  std::int64_t next_poll_ms_ = 0;
  std::string last_problem_;
};

}  // namespace rigsound::modbus
