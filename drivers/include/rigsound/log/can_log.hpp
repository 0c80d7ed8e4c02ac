// A recorded CAN bus.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/log/bus_log.hpp"
#include "rigsound/log/candump.hpp"

namespace rigsound::log {

/// A frame older than the one before it counts as simultaneous.
/// Thread: OFF.
class CanLog : public BusLog {
 public:
  /// `buses`: at least one. Frames go to the bus of their interface; when there is only one bus and the
  /// log knows only one interface, their names need not agree. Errors: InputError for a log that cannot
  /// be read, holds no frame, or none of any of these interfaces.
  CanLog(const std::filesystem::path& file, const std::vector<can::CanOptions>& buses);

  /// Errors: InputError with the line for a log that was cut off or jumps ahead by more than an hour.
  std::optional<double> next_s() override;
  bool read_until(double until_s, SignalBoard& board) override;
  std::vector<LogNote> notes() const override;

 private:
  void fetch();

  std::string file_;
  CandumpReader reader_;
  std::map<std::string, can::FrameDecoder> decoders_;  ///< by interface of the log
  std::optional<CanRecord> pending_;
  std::optional<std::int64_t> first_ns_;
  double time_s_ = 0;  ///< of pending_
  std::uint64_t used_ = 0;
  bool ended_ = false;
};

}  // namespace rigsound::log
