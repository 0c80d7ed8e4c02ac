// A recorded bus, of whatever kind, played onto the signal board at its own times.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/log/log_note.hpp"
#include "rigsound/machine/signal_board.hpp"
#include "rigsound/modbus/modbus_options.hpp"
#include "rigsound/udp/udp_options.hpp"

namespace rigsound::log {

/// The buses of a rig that a log may be of.
struct Buses {
  std::vector<can::CanOptions> can;
  std::vector<modbus::ModbusOptions> modbus;
  std::vector<udp::UdpOptions> udp;
};

/// How a log is to be taken.
struct LogOptions {
  std::optional<double> longest_gap_s;  ///< pauses over it are left out; nothing: all are kept
  std::vector<std::pair<std::string, std::string>> interfaces;  ///< CAN interface of the log, and of the rig
};

/// Time 0 is the first entry of the log. Thread: OFF.
class BusLog {
 public:
  virtual ~BusLog() = default;

  /// When the next entry arrived, s; nothing at the end. Errors: InputError.
  virtual std::optional<double> next_s() = 0;

  /// Puts every entry up to `until_s` on the board; returns whether one had a reading. Errors: InputError.
  virtual bool read_until(double until_s, SignalBoard& board) = 0;

  virtual double share() const = 0;  ///< of the file that has been read, 0...1

  /// What a user should know of a log read to its end.
  virtual std::vector<LogNote> notes() const = 0;
};

/// Modbus/TCP, UDP, or CAN as candump, Vector ASC, PEAK TRC or a capture has it; `-` is standard input, gzip
/// is unpacked. Errors: InputError for a file that cannot be read, of a kind of bus that the rig does not
/// have, or in which nothing is of use to the rig: then with the nearest thing that it holds.
std::unique_ptr<BusLog> open_log(const std::filesystem::path& file, const Buses& buses,
                                 const LogOptions& options);

}  // namespace rigsound::log
