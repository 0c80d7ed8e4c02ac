#include "rigsound/can/frame_decoder.hpp"

#include "rigsound/can/signal_reading.hpp"

namespace rigsound::can {

bool FrameDecoder::decode(const Frame& frame, double time_s, SignalBoard& board) const {
  bool used = false;
  for (const SignalRoute& route : routes_) {
    if (!matches(route.match, frame)) continue;
    used = true;
    const auto reading = read_signal(route.layout, route.match.j1939, frame);
    if (!reading) continue;
    if (reading->validity == Validity::kValid)
      board.update(route.target, reading->value, time_s);
    else
      board.invalidate(route.target, reading->validity);
  }
  return used;
}

}  // namespace rigsound::can
