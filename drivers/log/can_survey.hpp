// What a CAN log holds, for the user whose rig finds nothing in it.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/log/can_record.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::log {

/// Looks at frames until one has a value for a bus of the rig, and keeps what came nearest. Thread: OFF.
class CanSurvey {
 public:
  explicit CanSurvey(const std::vector<can::CanOptions>& buses) : buses_(buses) {}

  /// A frame of a bus of the rig; returns whether it has a value for it.
  bool add(const can::CanOptions& bus, const CanRecord& record);
  /// A frame of an interface that no bus of the rig has.
  void add_foreign(const CanRecord& record);

  std::uint64_t frames() const { return frames_; }
  /// Why nothing can be used, with what to do where that is plain.
  std::string nearest() const;

 private:
  bool add_message(const can::SignalRoute& route, const can::Frame& frame);
  void add_near(const can::SignalRoute& route, const can::Frame& frame);
  std::string most_frequent() const;

  std::vector<can::CanOptions> buses_;
  SignalBoard board_;
  std::uint64_t frames_ = 0, fd_frames_ = 0;
  std::map<std::pair<bool, std::uint32_t>, std::uint64_t> ids_;             // by (29 bits, identifier)
  std::string foreign_, addressed_, refused_, other_length_, transported_;  // the first of each kind
};

}  // namespace rigsound::log
