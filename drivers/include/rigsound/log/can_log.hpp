// A recorded CAN bus.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/can_reader.hpp"
#include "rigsound/log/log_clock.hpp"

namespace rigsound::can {
class SourceWatch;
}

namespace rigsound::log {

/// Times are those of a LogClock. Thread: OFF.
class CanLog : public BusLog {
 public:
  /// `buses`: at least one. Frames go to the bus of their interface, by the names of `options` where they are
  /// given; when there is only one bus and the log knows only one interface, their names need not agree. CAN
  /// FD frames count on buses with `fd` only. Errors: InputError for a log that cannot be read, holds no
  /// frame, none of any of these interfaces, or nothing that these buses can use.
  CanLog(LogFile file, const std::vector<can::CanOptions>& buses, const LogOptions& options);

  /// Errors: InputError with the line for a log that was cut off.
  std::optional<double> next_s() override;
  bool read_until(double until_s, SignalBoard& board) override;
  std::vector<LogNote> notes() const override;

 private:
  struct Bus {
    can::CanOptions options;
    can::FrameDecoder decoder;
    std::shared_ptr<can::SourceWatch> sources;
  };
  void find_buses(const std::vector<can::CanOptions>& buses, const LogOptions& options);
  void read_ahead();
  void fetch();
  void take_frame(SignalBoard& board);

  LogFile file_;
  std::unique_ptr<CanReader> reader_;
  std::map<std::string, Bus> buses_;  // by interface of the log
  LogClock clock_;
  CanRecord pending_, ahead_;
  bool has_pending_ = false, has_ahead_ = false;
  int ahead_line_ = 0;
  std::vector<Reading> readings_;  // of pending_
  double time_s_ = 0;              // of pending_
  std::uint64_t used_ = 0, fd_refused_ = 0;
  bool started_ = false;
};

}  // namespace rigsound::log
