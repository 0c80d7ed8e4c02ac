#include "rigsound/can/frame_decoder.hpp"

#include <algorithm>

#include "rigsound/can/signal_reading.hpp"

namespace rigsound::can {
namespace {

bool same(const MessageMatch& a, const MessageMatch& b) {
  return a.id == b.id && a.extended == b.extended && a.j1939 == b.j1939 && a.source == b.source;
}

}  // namespace

FrameDecoder::FrameDecoder(std::vector<SignalRoute> routes) : routes_(std::move(routes)) {
  for (std::size_t i = 0; i < routes_.size(); ++i) {
    const MessageMatch& match = routes_[i].match;
    auto message = std::find_if(messages_.begin(), messages_.end(),
                                [&](const Message& known) { return same(known.match, match); });
    if (message == messages_.end()) message = messages_.insert(messages_.end(), {match, {}});
    message->routes.push_back(i);
  }
}

bool FrameDecoder::decode(const Frame& frame, double time_s, std::vector<Reading>& out) const {
  bool used = false;
  for (const Message& message : messages_) {
    if (!matches(message.match, frame)) continue;
    used = true;
    const RawValues raw_values = message.match.j1939 ? RawValues::kJ1939 : RawValues::kAll;
    for (const std::size_t i : message.routes) {
      const auto decoded = read_signal(routes_[i].layout, raw_values, frame);
      if (decoded) out.push_back({routes_[i].target, decoded->value, decoded->validity, time_s});
    }
  }
  return used;
}

}  // namespace rigsound::can
