// A recorded bus, of whatever kind, played onto the signal board at its own times.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::log {

struct LogNote {
  std::string text;
  int line = 0;  ///< of the file; 0: it is about the whole
};

/// Time 0 is the first entry of the log. Thread: OFF.
class BusLog {
 public:
  virtual ~BusLog() = default;

  /// When the next entry arrived, s; nothing at the end. Errors: InputError.
  virtual std::optional<double> next_s() = 0;

  /// Puts every entry up to `until_s` on the board; returns whether one had a reading. Errors: InputError.
  virtual bool read_until(double until_s, SignalBoard& board) = 0;

  /// What a user should know of a log read to its end.
  virtual std::vector<LogNote> notes() const = 0;
};

/// `12.3`
std::string seconds_text(double seconds);

/// Modbus/TCP when the file is a pcap or pcapng, else CAN as candump writes it. Errors: InputError for a file
/// that cannot be read, or of a kind of bus that the rig does not have.
std::unique_ptr<BusLog> open_log(const std::filesystem::path& file, const std::vector<can::CanOptions>& can,
                                 const std::vector<modbus::ModbusOptions>& modbus);

}  // namespace rigsound::log
