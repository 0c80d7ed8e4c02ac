// Frames of one CAN bus into readings.
#pragma once

#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/machine/reading.hpp"

namespace rigsound::can {

class FrameDecoder {
 public:
  explicit FrameDecoder(std::vector<SignalRoute> routes);

  /// Adds a reading for every signal of the frame to `out`, true at `time_s`. Returns false when the frame
  /// carries no message this bus knows. Thread: CT.
  bool decode(const Frame& frame, double time_s, std::vector<Reading>& out) const;

  const std::vector<SignalRoute>& routes() const { return routes_; }

 private:
  /// Routes of one message, by their places.
  struct Message {
    MessageMatch match;
    std::vector<std::size_t> routes;
  };

  std::vector<SignalRoute> routes_;
  std::vector<Message> messages_;
};

}  // namespace rigsound::can
