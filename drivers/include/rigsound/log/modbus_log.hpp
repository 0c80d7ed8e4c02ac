// Recorded Modbus/TCP.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/modbus_capture.hpp"

namespace rigsound::log {

/// Every Modbus bus of the rig gets every exchange of the capture, of its unit when it names one: a rig is
/// not asked which hosts the recording was made on. Thread: OFF.
class ModbusLog : public BusLog {
 public:
  /// Errors: InputError for a file that is no capture or holds no exchange.
  ModbusLog(const std::filesystem::path& file, const std::vector<modbus::ModbusOptions>& buses);

  std::optional<double> next_s() override;
  bool read_until(double until_s, SignalBoard& board) override;
  std::vector<LogNote> notes() const override;

 private:
  void fetch();

  ModbusCapture capture_;
  std::vector<modbus::ModbusOptions> buses_;
  std::optional<TimedExchange> pending_;
  std::int64_t first_ns_ = 0;
  double time_s_ = 0;  ///< of pending_
  std::uint64_t used_ = 0;
};

}  // namespace rigsound::log
