// A frame of a CAN bus, classic or FD.
#pragma once

#include <array>
#include <cstdint>

namespace rigsound::can {

constexpr int kMaxData = 64;  ///< bytes in the longest CAN FD frame
constexpr std::uint32_t kMaxStandardId = 0x7FF, kMaxExtendedId = 0x1FFFFFFF;  ///< all 11 and all 29 bits

/// Plain data. Thread: any.
struct Frame {
  std::uint32_t id = 0;   ///< 11 or 29 bits, no flags; for an error frame its error class bits
  bool extended = false;  ///< 29 bit identifier
  bool remote = false;    ///< RTR: asks for data, carries none
  bool error = false;     ///< error frame made by the controller, `id` holds the error classes
  bool fd = false;
  bool bit_rate_switch = false;  ///< FD only
  bool error_passive = false;    ///< FD only: ESI, the sender is error passive
  std::uint8_t size = 0;         ///< bytes in `data`; of a remote frame: the bytes asked for
  std::uint8_t raw_dlc =
      0;  ///< 9...15 when a classic frame of 8 bytes was sent with such a length code; else 0
  std::array<std::uint8_t, kMaxData> data{};
};

/// A frame and when it came.
struct Arrival {
  Frame frame;
  double realtime_s = 0;  ///< when the kernel got it, seconds since 1970; 0: it did not say
};

}  // namespace rigsound::can
