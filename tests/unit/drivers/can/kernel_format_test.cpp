// Frames as SocketCAN has them and as we have them, there and back.
#include "can/kernel_format.hpp"

#include <doctest/doctest.h>

#include <cstring>

using namespace rigsound::can;

namespace {

canfd_frame raw_frame(canid_t id, int length, int length_code = 0) {
  can_frame classic{};
  classic.can_id = id;
  classic.len = static_cast<__u8>(length);
  classic.len8_dlc = static_cast<__u8>(length_code);
  for (int i = 0; i < 8; ++i) classic.data[i] = static_cast<__u8>(i + 1);
  canfd_frame raw{};
  std::memcpy(&raw, &classic, sizeof classic);
  return raw;
}

}  // namespace

TEST_CASE("A classic frame from the kernel: identifier, kind, length and bytes") {
  const Frame f = from_kernel(raw_frame(0x123, 3), CAN_MTU);
  CHECK(f.id == 0x123);
  CHECK_FALSE(f.extended);
  CHECK_FALSE(f.remote);
  CHECK_FALSE(f.error);
  CHECK_FALSE(f.fd);
  CHECK(f.size == 3);
  CHECK(f.data[0] == 1);
  CHECK(f.data[2] == 3);
  CHECK(f.data[3] == 0);                                         // not of this frame
  CHECK(from_kernel(raw_frame(0x9FF, 0), CAN_MTU).id == 0x1FF);  // 11 bits
  const Frame extended = from_kernel(raw_frame(0x18FEF100 | CAN_EFF_FLAG, 8), CAN_MTU);
  CHECK(extended.extended);
  CHECK(extended.id == 0x18FEF100);
  CHECK(extended.size == 8);
  CHECK(from_kernel(raw_frame(1, 9), CAN_MTU).size == 8);  // never more than there is
  const Frame error = from_kernel(raw_frame(0x1F000 | CAN_ERR_FLAG, 8), CAN_MTU);
  CHECK(error.error);
  CHECK(error.id == 0x1F000);
  const Frame remote = from_kernel(raw_frame(5 | CAN_RTR_FLAG, 4), CAN_MTU);
  CHECK(remote.remote);
  CHECK(remote.size == 4);
  CHECK(remote.data[0] == 0);  // it carries none
}

TEST_CASE("A length code over 8 is kept for a classic frame of 8 bytes, and for no other") {
  CHECK(from_kernel(raw_frame(1, 8, 15), CAN_MTU).raw_dlc == 15);
  CHECK(from_kernel(raw_frame(1, 8, 9), CAN_MTU).raw_dlc == 9);
  CHECK(from_kernel(raw_frame(1, 8, 8), CAN_MTU).raw_dlc == 0);
  CHECK(from_kernel(raw_frame(1, 8, 0), CAN_MTU).raw_dlc == 0);
  CHECK(from_kernel(raw_frame(1, 7, 9), CAN_MTU).raw_dlc == 0);
}

TEST_CASE("A CAN FD frame from the kernel has its flags and up to 64 bytes") {
  canfd_frame raw{};
  raw.can_id = 0x55;
  raw.len = 70;
  raw.data[63] = 9;
  for (const bool switched : {false, true})
    for (const bool passive : {false, true}) {
      raw.flags = static_cast<__u8>((switched ? CANFD_BRS : 0) | (passive ? CANFD_ESI : 0));
      const Frame f = from_kernel(raw, CANFD_MTU);
      CHECK(f.fd);
      CHECK(f.size == 64);
      CHECK(f.data[63] == 9);
      CHECK(f.bit_rate_switch == switched);
      CHECK(f.error_passive == passive);
      CHECK(f.raw_dlc == 0);
    }
}

TEST_CASE("What goes to the kernel comes back as it was") {
  Frame f;
  f.data[0] = 1, f.data[7] = 8;
  f.size = 8;
  const auto back = [&](std::size_t size) {
    canfd_frame raw;
    CHECK(to_kernel(f, raw) == size);
    const Frame again = from_kernel(raw, size);
    CHECK(again.id == f.id);
    CHECK(again.extended == f.extended);
    CHECK(again.remote == f.remote);
    CHECK(again.error == f.error);
    CHECK(again.fd == f.fd);
    CHECK(again.bit_rate_switch == f.bit_rate_switch);
    CHECK(again.error_passive == f.error_passive);
    CHECK(again.size == f.size);
    CHECK(again.raw_dlc == f.raw_dlc);
    CHECK(again.data == (f.remote ? Frame().data : f.data));
  };
  f.id = 0x7FF;
  back(CAN_MTU);
  f.size = 3, f.data = {1, 2, 3};
  back(CAN_MTU);
  f.size = 8, f.data[7] = 8;
  f.extended = true, f.id = 0x1FFFFFFF, f.raw_dlc = 12;
  back(CAN_MTU);
  f.remote = true;
  back(CAN_MTU);
  f.remote = false, f.error = true, f.raw_dlc = 0;
  back(CAN_MTU);
  f.error = false, f.fd = true, f.size = 64, f.data[63] = 3;
  for (const bool switched : {false, true}) {
    f.bit_rate_switch = switched, f.error_passive = !switched;
    back(CANFD_MTU);
  }
  f.data.fill(0xA5);
  back(CANFD_MTU);
  f.extended = false, f.id = 0x55;
  back(CANFD_MTU);
}
