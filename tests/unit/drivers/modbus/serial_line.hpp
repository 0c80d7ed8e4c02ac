// A pseudo terminal: the link has the device, the test is the other end of the line.
#pragma once

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <cstdint>
#include <string>
#include <vector>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::modbus {

using Bytes = std::vector<std::uint8_t>;

// CRC-16/MODBUS: polynomial 0xA001 reflected, start 0xFFFF, low byte first on the line.
inline Bytes with_checksum(Bytes frame) {
  unsigned crc = 0xffff;
  for (const std::uint8_t byte : frame) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xa001 : crc >> 1;
  }
  frame.push_back(static_cast<std::uint8_t>(crc & 0xff));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

class SerialLine {
 public:
  SerialLine() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    REQUIRE(::grantpt(master_.get()) == 0);
    REQUIRE(::unlockpt(master_.get()) == 0);
  }
  std::string device() const { return ::ptsname(master_.get()); }
  void cut() { master_.reset(); }

  void say(const Bytes& bytes) {
    REQUIRE(::write(master_.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  Bytes hear(std::size_t count) {
    Bytes heard;
    while (heard.size() < count) {
      pollfd poll{master_.get(), POLLIN, 0};
      REQUIRE(::poll(&poll, 1, 60000) == 1);
      std::uint8_t byte = 0;
      REQUIRE(::read(master_.get(), &byte, 1) == 1);
      heard.push_back(byte);
    }
    return heard;
  }

 private:
  FileDescriptor master_;
};

}  // namespace rigsound::modbus
