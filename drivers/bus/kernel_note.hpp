// What the kernel says beside a message it hands over.
#pragma once

#include <cstdint>
#include <optional>

struct msghdr;

namespace rigsound {

struct KernelNote {
  double realtime_s = 0;                 ///< when it came, seconds since 1970; 0: the kernel does not say
  std::optional<std::uint32_t> dropped;  ///< by the socket since it was opened, for lack of room
};

/// Of a socket with SO_TIMESTAMPNS and SO_RXQ_OVFL on. Thread: any.
KernelNote kernel_note(msghdr& header);

}  // namespace rigsound
