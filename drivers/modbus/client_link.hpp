// The line to a device that is asked for its registers.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modbus/context.hpp"
#include "modbus/poll_plan.hpp"
#include "rigsound/bus/stop_event.hpp"
#include "rigsound/file/file_descriptor.hpp"
#include "rigsound/modbus/exchange.hpp"

namespace rigsound::modbus {

/// Connected from construction to destruction. libmodbus opens the serial line; questions and answers are
/// framed here, because nothing ends a wait of libmodbus before its time. Thread: CT.
class ClientLink {
 public:
  /// `stop` ends whatever is waited for, and must outlive the link. Errors: DeviceError.
  ClientLink(const ModbusOptions& options, const StopEvent& stop);

  /// One read of a table of `unit`. Returns 0, or why not, for modbus_strerror(): exceptions of the device as
  /// libmodbus numbers them, ETIMEDOUT, what the line said; ECANCELED once stopped.
  int read(int unit, const PollRequest& request, Exchange& answer);

 private:
  int fd() const;
  void drain();
  int send(std::vector<std::uint8_t> unit_and_pdu);
  int receive();
  int receive_some(int timeout_ms);
  int take(int unit, std::uint8_t function, Exchange& answer) const;

  const StopEvent& stop_;
  bool rtu_;        // frames of a serial line, also over TCP
  int timeout_ms_;  // until an answer begins
  Context serial_;
  FileDescriptor socket_;
  std::uint16_t transaction_ = 0;
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> bytes_{};  // of the answer
  std::size_t filled_ = 0, frame_ = 0;
};

}  // namespace rigsound::modbus
