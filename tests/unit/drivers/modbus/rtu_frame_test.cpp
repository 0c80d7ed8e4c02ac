// How long frames of a serial line are, by the Modbus application protocol: unit, PDU, checksum.
#include "modbus/rtu_frame.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace rigsound::modbus;

namespace {

using RtuBytes = std::vector<std::uint8_t>;

std::optional<std::size_t> size_of(RtuSide side, const RtuBytes& bytes) {
  return rtu_frame_size(side, bytes.data(), bytes.size());
}

}  // namespace

TEST_CASE("requests and answers of a fixed length are told by their function") {
  for (const std::uint8_t function : RtuBytes{1, 2, 3, 4, 5, 6})  // address and count or value
    CHECK(size_of(RtuSide::kRequest, {1, function}) == 1 + 5 + 2);
  for (const std::uint8_t function : RtuBytes{5, 6, 15, 16})  // address and value or count
    CHECK(size_of(RtuSide::kAnswer, {1, function}) == 1 + 5 + 2);
  for (const RtuSide side : {RtuSide::kRequest, RtuSide::kAnswer})
    CHECK(size_of(side, {1, 22}) == 1 + 7 + 2);  // address and two masks
  for (const std::uint8_t function : RtuBytes{1, 3, 6, 16, 22, 23, 43})
    CHECK(size_of(RtuSide::kAnswer, {1, static_cast<std::uint8_t>(0x80 | function)}) == 1 + 2 + 2);
}

TEST_CASE("where bytes are counted, their count is waited for and added") {
  for (const std::uint8_t function : RtuBytes{15, 16}) {  // address, count, bytes
    CHECK(size_of(RtuSide::kRequest, {1, function, 0, 0, 0, 2}) == 0);
    CHECK(size_of(RtuSide::kRequest, {1, function, 0, 0, 0, 2, 4}) == 1 + 6 + 4 + 2);
  }
  CHECK(size_of(RtuSide::kRequest, {1, 23, 0, 0, 0, 1, 0, 0, 0, 2}) == 0);
  CHECK(size_of(RtuSide::kRequest, {1, 23, 0, 0, 0, 1, 0, 0, 0, 2, 4}) == 1 + 10 + 4 + 2);
  for (const std::uint8_t function : RtuBytes{1, 2, 3, 4, 23}) {
    CHECK(size_of(RtuSide::kAnswer, {1, function}) == 0);
    CHECK(size_of(RtuSide::kAnswer, {1, function, 7}) == 1 + 2 + 7 + 2);
  }
}

TEST_CASE("a frame is 256 bytes at most, and of no function that is not known") {
  CHECK(size_of(RtuSide::kAnswer, {1, 3, 251}) == 256);
  CHECK_FALSE(size_of(RtuSide::kAnswer, {1, 3, 252}));
  CHECK(size_of(RtuSide::kRequest, {1, 16, 0, 0, 0, 123, 247}) == 256);
  CHECK_FALSE(size_of(RtuSide::kRequest, {1, 16, 0, 0, 0, 124, 248}));
  for (const RtuSide side : {RtuSide::kRequest, RtuSide::kAnswer})
    for (const std::uint8_t function : RtuBytes{0, 7, 43, 127}) CHECK_FALSE(size_of(side, {1, function}));
  CHECK(size_of(RtuSide::kAnswer, {1}) == 0);  // no function yet
}

TEST_CASE("the checksum is that of the serial line's specification, low byte first") {
  // Modbus over serial line V1.02, 6.2.2: of 02 07 it is 0x1241.
  RtuBytes frame = {0x02, 0x07, 0x41, 0x12};
  CHECK(rtu_checksum(frame.data(), 2) == 0x1241);
  CHECK(rtu_checksum_holds(frame.data(), frame.size()));
  CHECK_FALSE(rtu_checksum_holds(frame.data(), 3));
  frame[2] ^= 1;
  CHECK_FALSE(rtu_checksum_holds(frame.data(), frame.size()));
}
