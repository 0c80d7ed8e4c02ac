// Two byte streams between a client and a server, turned into exchanges.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "log/frame_stream.hpp"
#include "rigsound/modbus/exchange.hpp"

namespace rigsound::log {

class Conversation {
 public:
  explicit Conversation(Framing framing = Framing::kMbap)
      : to_server(framing, modbus::RtuSide::kRequest), to_client(framing, modbus::RtuSide::kAnswer) {}

  enum class Answer : std::uint8_t { kAgreed, kRefused, kUnpaired, kOtherFunction };

  void request(const std::vector<std::uint8_t>& frame);
  /// kAgreed adds one exchange, or two: a read after a write (function 23).
  Answer answer(const std::vector<std::uint8_t>& frame, std::vector<modbus::Exchange>& out);

  FrameStream to_server, to_client;

 private:
  std::map<unsigned, std::vector<std::uint8_t>> waiting_;  // requests by transaction number
  std::map<std::pair<int, std::uint16_t>, std::uint16_t>
      held_;  // holding registers seen, by unit and address
};

}  // namespace rigsound::log
