#include "can/kernel_format.hpp"

#include <doctest/doctest.h>

#include "can/kernel_format.hpp"

using namespace rigsound::can;

namespace {

bool passes(const std::vector<can_filter>& filters, canid_t id) {
  for (const can_filter& f : filters)
    if ((id & f.can_mask) == (f.can_id & f.can_mask)) return true;
  return false;
}

MessageMatch j1939(std::uint32_t id) {
  MessageMatch m;
  m.id = id;
  m.extended = m.j1939 = true;
  return m;
}

}  // namespace

TEST_CASE("A plain message passes by its identifier, its frame format and only as data") {
  MessageMatch standard, extended;
  standard.id = extended.id = 0x123;
  extended.extended = true;
  CHECK(passes(kernel_filters({standard}), 0x123));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x124));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x123 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({standard}), 0x123 | CAN_RTR_FLAG));
  CHECK(passes(kernel_filters({extended}), 0x123 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({extended}), 0x123));
  CHECK(kernel_filters({standard, standard, extended}).size() == 2);
}

TEST_CASE("A J1939 message passes by its PGN, from any source unless one is named") {
  const auto eec1 = kernel_filters({j1939(0x0CF00400)});
  CHECK(passes(eec1, 0x0CF00400 | CAN_EFF_FLAG));
  CHECK(passes(eec1, 0x18F00421 | CAN_EFF_FLAG));        // another priority and source
  CHECK_FALSE(passes(eec1, 0x0CF00500 | CAN_EFF_FLAG));  // PF 240: PS belongs to the PGN
  CHECK_FALSE(passes(eec1, 0x0DF00400 | CAN_EFF_FLAG));  // data page 1
  MessageMatch named = j1939(0x0CF00400);
  named.source = 0x21;
  CHECK(passes(kernel_filters({named}), 0x18F00421 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(kernel_filters({named}), 0x0CF00400 | CAN_EFF_FLAG));
  const auto addressed = kernel_filters({j1939(0x18EF0000)});  // PF 239: PS is a destination
  CHECK(passes(addressed, 0x18EF2133 | CAN_EFF_FLAG));
  CHECK_FALSE(passes(addressed, 0x18EE0000 | CAN_EFF_FLAG));
}

TEST_CASE("Frames survive the way to the kernel and back") {
  Frame classic, fd, remote, long_dlc;
  classic.id = 0x7FF;
  classic.size = 3;
  classic.data = {1, 2, 3};
  fd.id = 0x1ABCDEFF;
  fd.extended = fd.fd = fd.bit_rate_switch = true;
  fd.size = 64;
  fd.data.fill(0xA5);
  remote.remote = true;
  remote.size = 4;
  long_dlc.size = 8;
  long_dlc.raw_dlc = 13;
  for (const Frame& f : {classic, fd, remote, long_dlc}) {
    canfd_frame raw;
    const Frame back = from_kernel(raw, to_kernel(f, raw));
    CHECK(back.id == f.id);
    CHECK(back.extended == f.extended);
    CHECK(back.remote == f.remote);
    CHECK(back.fd == f.fd);
    CHECK(back.bit_rate_switch == f.bit_rate_switch);
    CHECK(back.size == f.size);
    CHECK(back.raw_dlc == f.raw_dlc);
    CHECK(back.data == f.data);
  }
}
