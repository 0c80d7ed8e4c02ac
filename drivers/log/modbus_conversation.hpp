// Two byte streams between a client and a server, turned into exchanges.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "log/tcp_packet.hpp"
#include "rigsound/modbus/exchange.hpp"

namespace rigsound::log {

/// One direction: segments put in order, cut into Modbus/TCP frames.
class FrameStream {
 public:
  /// A segment repeated or overlapping is taken once; after a gap the stream starts anew. Returns false when
  /// the bytes are no Modbus/TCP.
  bool add(const TcpPacket& packet);

  /// The next whole frame, MBAP header included; empty when there is none.
  std::vector<std::uint8_t> next();

 private:
  std::optional<std::uint32_t> expected_;
  std::vector<std::uint8_t> bytes_;
};

class Conversation {
 public:
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
