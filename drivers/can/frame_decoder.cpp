#include "rigsound/can/frame_decoder.hpp"

#include "rigsound/can/signal_reading.hpp"

namespace rigsound::can {

bool FrameDecoder::decode(const Frame& frame, double time_s, std::vector<Reading>& out) const {
  bool used = false;
  for (const SignalRoute& route : routes_) {
    if (!matches(route.match, frame)) continue;
    used = true;
    const RawValues raw_values = route.match.j1939 ? RawValues::kJ1939 : RawValues::kAll;
    const auto decoded = read_signal(route.layout, raw_values, frame);
    if (decoded) out.push_back({route.target, decoded->value, decoded->validity, time_s});
  }
  return used;
}

}  // namespace rigsound::can
