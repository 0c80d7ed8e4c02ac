#include "bus/kernel_note.hpp"

#include <sys/socket.h>

#include <cstring>
#include <ctime>

namespace rigsound {

KernelNote kernel_note(msghdr& header) {
  KernelNote note;
  for (cmsghdr* c = CMSG_FIRSTHDR(&header); c != nullptr; c = CMSG_NXTHDR(&header, c)) {
    if (c->cmsg_level != SOL_SOCKET) continue;
    if (c->cmsg_type == SO_TIMESTAMPNS) {
      timespec t{};
      std::memcpy(&t, CMSG_DATA(c), sizeof t);
      note.realtime_s = static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    } else if (c->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t dropped = 0;
      std::memcpy(&dropped, CMSG_DATA(c), sizeof dropped);
      note.dropped = dropped;
    }
  }
  return note;
}

}  // namespace rigsound
