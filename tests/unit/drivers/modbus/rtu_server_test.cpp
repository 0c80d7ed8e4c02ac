// The serial server on a pseudo terminal: the test is the other end of the line.
#include "modbus/rtu_server.hpp"

#include <doctest/doctest.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "drivers/modbus/bus_harness.hpp"
#include "drivers/modbus/serial_line.hpp"

namespace fs = std::filesystem;
using namespace rigsound;
using namespace rigsound::modbus;

namespace {

struct OpenedLine : SerialLine {
  OpenedLine() {
    options.transport = Transport::kRtu;
    options.address = device();
    options.unit = 17;
    options.routes = {route(Signal::kFeedPressureBar, Table::kHolding, 0)};
    server = std::make_unique<RtuServer>(options, told, nullptr);
    server->step();  // opens the line
  }
  /// What the server reads the line through.
  int descriptor() const {
    for (const fs::directory_entry& entry : fs::directory_iterator("/proc/self/fd"))
      if (std::error_code gone; fs::read_symlink(entry, gone) == device())
        return std::stoi(entry.path().filename());
    FAIL("the line is not open");
    return -1;
  }

  ModbusOptions options;
  Told told;
  std::unique_ptr<RtuServer> server;
};

struct ServedLine : OpenedLine {
  Running running{*server};
};

const Bytes kWrite85 = with_checksum({17, 6, 0, 0, 0, 85});

}  // namespace

TEST_CASE("A write over the line arrives and is confirmed") {
  ServedLine line;
  line.say(kWrite85);
  CHECK(line.hear(kWrite85.size()) == kWrite85);
  await([&] { return line.told.total() == 1; });
  await([&] { return line.told.of(Signal::kFeedPressureBar).value == 85; });
}

TEST_CASE("Other units' frames, broken checksums and refused values change nothing") {
  ServedLine line;
  const Bytes other = with_checksum({18, 6, 0, 0, 0, 85});
  line.say(other);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a pause on the line ends a frame
  line.say(other);                                             // the other unit's answer is the same bytes
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  Bytes broken = kWrite85;
  broken.back() ^= 0xff;
  line.say(broken);
  await([&] { return count(*line.server, "frames_bad") == 1; });
  line.say(with_checksum({17, 6, 0, 0, 2, 0}));
  CHECK(line.hear(5) == with_checksum({17, 0x86, 3}));
  line.say(kWrite85);
  line.hear(kWrite85.size());
  await([&] { return line.told.total() == 1; });
  CHECK(count(*line.server, "requests_refused") == 1);
  await([&] { return count(*line.server, "frames_used") == 1; });
  CHECK(count(*line.server, "frames_seen") == 3);  // used, refused and bad
}

TEST_CASE("A broadcast is obeyed and never answered, refused or not") {
  ServedLine line;
  line.say(with_checksum({0, 6, 0, 9, 0, 85}));  // no such register
  await([&] { return count(*line.server, "requests_refused") == 1; });
  line.say(with_checksum({0, 6, 0, 0, 0, 85}));
  await([&] { return line.told.of(Signal::kFeedPressureBar).value == 85; });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  line.say(kWrite85);
  CHECK(line.hear(kWrite85.size()) == kWrite85);  // the first bytes of the server
}

TEST_CASE("A function that is not served is answered with exception 1, in one frame with anything after it") {
  ServedLine line;
  for (const Bytes& request : {Bytes{17, 0x2b, 0x0e, 1, 0}, Bytes{17, 7}, Bytes{17, 8, 0, 0, 0xA5, 0x37},
                               Bytes{17, 0x64, 1, 2, 3}}) {
    line.say(with_checksum(request));
    CHECK(line.hear(5) == with_checksum({17, static_cast<std::uint8_t>(request[1] | 0x80), 1}));
  }
  CHECK(count(*line.server, "requests_refused") == 4);
  CHECK(count(*line.server, "frames_bad") == 0);
  line.say(with_checksum({0, 0x2b, 0x0e, 1, 0}));  // to all: nobody answers
  line.say(with_checksum({18, 0x2b, 0x0e, 1, 0}));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  line.say(kWrite85);
  CHECK(line.hear(kWrite85.size()) == kWrite85);
}

TEST_CASE("On a line with other units, their answers are no requests, however close the next frame follows") {
  ServedLine line;
  Bytes traffic;
  const auto add = [&](const Bytes& frame) { traffic.insert(traffic.end(), frame.begin(), frame.end()); };
  add(with_checksum({18, 3, 0, 0, 0, 2}));       // the master asks another unit,
  add(with_checksum({18, 3, 4, 0, 85, 0, 90}));  // which answers,
  add(with_checksum({18, 0x83, 2}));             // or refuses
  add(kWrite85);
  line.say(traffic);
  CHECK(line.hear(kWrite85.size()) == kWrite85);
  CHECK(count(*line.server, "frames_bad") == 0);
}

TEST_CASE("More bytes than a frame has are one broken frame, until the line is silent") {
  ServedLine line;
  line.say(Bytes(700, 0xA5));
  await([&] { return count(*line.server, "frames_bad") >= 1; });
  line.say(kWrite85);
  CHECK(line.hear(kWrite85.size()) == kWrite85);
}

TEST_CASE("A line that goes away is told, and looked for") {
  ServedLine line;
  line.cut();
  await([&] { return line.told.downs() == 1; });
  await([&] { return line.told.notices() >= 1; });
}

// As of an adapter that is pulled out: something is to be read, and reading fails. So does reading a folder.
TEST_CASE("A line that cannot be read is lost, told with why, and looked for") {
  OpenedLine line;
  const FileDescriptor folder(::open("/", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const int read_through = line.descriptor();
  REQUIRE(::dup2(folder.get(), read_through) == read_through);
  line.server->step();
  CHECK(line.told.downs() == 1);
  CHECK(line.told.last_text() == std::strerror(EISDIR));
  CHECK(count(*line.server, "losses") == 1);
}
