// A recorded bus, of whatever kind, played onto the signal board at its own times.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/modbus/modbus_options.hpp"
#include "rigsound/signal_board.hpp"

namespace rigsound::log {

/// Something people should know about a log; `line` counts from 1, 0 means the whole file.
struct LogNote {
  std::string text;
  std::uint64_t line = 0;
};

/// Time 0 is the first entry of the log. Thread: OFF.
class BusLog {
 public:
  virtual ~BusLog() = default;

  /// When the next entry arrived, s; nothing at the end. Errors: InputError.
  virtual std::optional<double> next_s() = 0;

  /// Puts every entry up to `until_s` on the board. Errors: InputError.
  virtual void advance(double until_s, SignalBoard& board) = 0;

  /// What a user should know of a log read to its end, one line each, without the file's name.
  virtual std::vector<LogNote> notes() const = 0;
};

/// Modbus/TCP when the file is a pcap or pcapng, else CAN as candump writes it. Errors: InputError for a file
/// that cannot be read, or of a kind of bus that the rig does not have.
std::unique_ptr<BusLog> open_log(const std::filesystem::path& file, const std::vector<can::CanOptions>& can,
                                 const std::vector<modbus::ModbusOptions>& modbus);

}  // namespace rigsound::log
