// Frames of one CAN bus into readings on the signal board.
#pragma once

#include <vector>

#include "rigsound/can/can_options.hpp"
#include "rigsound/can/frame.hpp"
#include "rigsound/machine/signal_board.hpp"

namespace rigsound::can {

class FrameDecoder {
 public:
  explicit FrameDecoder(std::vector<SignalRoute> routes) : routes_(std::move(routes)) {}

  /// Puts every signal of the frame on the board, as seen at `time_s`. Returns false when the frame
  /// carries no message this bus knows. Thread: CT.
  bool decode(const Frame& frame, double time_s, SignalBoard& board) const;

  const std::vector<SignalRoute>& routes() const { return routes_; }

 private:
  std::vector<SignalRoute> routes_;
};

}  // namespace rigsound::can
