// One direction of a TCP connection, cut into Modbus frames.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "log/ip_packet.hpp"
#include "modbus/rtu_frame.hpp"

namespace rigsound::log {

/// How frames lie in the stream.
enum class Framing : std::uint8_t { kMbap, kRtu };

class FrameStream {
 public:
  explicit FrameStream(Framing framing = Framing::kMbap, modbus::RtuSide side = modbus::RtuSide::kRequest)
      : framing_(framing), side_(side) {}

  /// A segment repeated or overlapping is taken once. After a gap the stream starts anew; a segment that
  /// comes late fills its gap. Returns false when the bytes are no Modbus.
  bool add(const TcpPacket& packet);

  /// The next whole frame, with an MBAP header whatever the framing (transaction 0 for RTU); empty when there
  /// is none.
  std::vector<std::uint8_t> next();

 private:
  using Bytes = std::vector<std::uint8_t>;
  /// What is missing, and what of it has come late.
  struct Gap {
    std::uint32_t begin, end;
    Bytes bytes;
  };
  bool fill_gap(const TcpPacket& packet);
  bool cut(Bytes& bytes);

  Framing framing_;
  modbus::RtuSide side_;
  std::optional<std::uint32_t> expected_;
  Bytes bytes_;
  std::deque<Gap> gaps_;
  std::deque<Bytes> frames_;
};

}  // namespace rigsound::log
