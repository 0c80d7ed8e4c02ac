// The serial server on a pseudo terminal: the test is the other end of the line.
#include "modbus/rtu_server.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include "drivers/modbus/link_harness.hpp"
#include "rigsound/file/file_descriptor.hpp"

using namespace rigsound;
using namespace rigsound::modbus;

namespace {

using Bytes = std::vector<std::uint8_t>;

// CRC-16/MODBUS: polynomial 0xA001 reflected, start 0xFFFF, low byte first on the line.
Bytes with_checksum(Bytes frame) {
  unsigned crc = 0xffff;
  for (const std::uint8_t byte : frame) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xa001 : crc >> 1;
  }
  frame.push_back(static_cast<std::uint8_t>(crc & 0xff));
  frame.push_back(static_cast<std::uint8_t>(crc >> 8));
  return frame;
}

struct Line {
  Line() : master(::posix_openpt(O_RDWR | O_NOCTTY)) {
    REQUIRE(::grantpt(master.get()) == 0);
    REQUIRE(::unlockpt(master.get()) == 0);
    options.transport = Transport::kRtu;
    options.address = ::ptsname(master.get());
    options.unit = 17;
    options.routes = {route(Signal::kFeedPressureBar, Table::kHolding, 0)};
    server = std::make_unique<RtuServer>(options, told);
    server->step();  // opens the line
    running = std::make_unique<Running>(*server);
  }

  void say(const Bytes& bytes) {
    REQUIRE(::write(master.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }

  Bytes hear(std::size_t count) {
    Bytes heard;
    while (heard.size() < count) {
      pollfd poll{master.get(), POLLIN, 0};
      REQUIRE(::poll(&poll, 1, 60000) == 1);
      std::uint8_t byte = 0;
      REQUIRE(::read(master.get(), &byte, 1) == 1);
      heard.push_back(byte);
    }
    return heard;
  }

  FileDescriptor master;
  ModbusOptions options;
  Told told;
  std::unique_ptr<RtuServer> server;
  std::unique_ptr<Running> running;
};

const Bytes kWrite85 = with_checksum({17, 6, 0, 0, 0, 85});

}  // namespace

TEST_CASE("A write over the line arrives and is confirmed") {
  Line line;
  line.say(kWrite85);
  CHECK(line.hear(kWrite85.size()) == kWrite85);
  await([&] { return line.told.total() == 1; });
  await([&] { return line.told.of(Signal::kFeedPressureBar).value == 85; });
}

TEST_CASE("Other units' frames, broken checksums and refused values change nothing") {
  Line line;
  const Bytes other = with_checksum({18, 6, 0, 0, 0, 85});
  line.say(other);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a pause on the line ends a frame
  line.say(other);                                             // the other unit's answer is the same bytes
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  Bytes broken = kWrite85;
  broken.back() ^= 0xff;
  line.say(broken);
  await([&] { return line.server->counters().bad_frames == 1; });
  line.say(with_checksum({17, 6, 0, 0, 2, 0}));
  CHECK(line.hear(5) == with_checksum({17, 0x86, 3}));
  line.say(kWrite85);
  line.hear(kWrite85.size());
  await([&] { return line.told.total() == 1; });
  CHECK(line.server->counters().refused == 1);
}

TEST_CASE("A line that goes away is told, and looked for") {
  Line line;
  line.master.reset();
  await([&] { return line.told.downs() == 1; });
  await([&] { return line.told.notices() >= 1; });
}
