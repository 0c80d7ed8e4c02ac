// Recorded Modbus/TCP.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/modbus_capture.hpp"
#include "rigsound/log/placed_entries.hpp"

namespace rigsound::log {

/// A Modbus bus of the rig gets the exchanges with its own server: of its address and port for a client, of
/// its port for a server. When the capture knows one server only, and no bus of the rig is it, all get those
/// exchanges: a recording may be of another place. Of its unit when it names one. Thread: OFF.
class ModbusLog : public BusLog {
 public:
  /// Errors: InputError for a file that is no capture or holds no exchange, none with a server of the rig, or
  /// none that these buses can use.
  ModbusLog(LogFile file, const std::vector<modbus::ModbusOptions>& buses, const LogOptions& options);

  std::optional<double> next_s() override;
  bool read_until(double until_s, SignalBoard& board) override;
  double share() const override { return capture_->share(); }
  std::vector<LogNote> notes() const override;

 private:
  void survey();
  void choose_servers(const std::vector<std::string>& servers);
  void read_for(std::size_t bus, const TimedExchange& entry, double time_s, std::vector<Reading>& out) const;

  LogFile file_;
  std::vector<modbus::ModbusOptions> buses_;
  std::vector<std::optional<std::string>> server_;  // of each bus, as text_of(); nothing: any
  std::unique_ptr<ModbusCapture> capture_;
  PlacedEntries<ModbusCapture, TimedExchange> entries_;
  std::uint64_t used_ = 0;
  std::vector<LogNote> notes_;  // of the survey
};

}  // namespace rigsound::log
