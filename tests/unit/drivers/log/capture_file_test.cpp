// pcap in its four forms and pcapng with its blocks, whole, cut off and damaged; pcap as we write it.
#include "log/capture_file.hpp"

#include <doctest/doctest.h>
#include <pcap/dlt.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "drivers/log/made_packets.hpp"
#include "log/can_capture.hpp"
#include "log/capture_dump.hpp"
#include "rigsound/device_error.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::log;
using test::Octets;
using test::octets;
using test::operator+;

namespace {

std::vector<CapturedPacket> packets_of(const Octets& bytes) {
  const test::TemporaryFolder folder;
  const LogFile file(folder.write("capture", test::text_of(bytes)));
  CaptureFile capture(file);
  std::vector<CapturedPacket> packets;
  for (CapturedPacket packet; capture.next(packet);) packets.push_back(packet);
  CHECK(capture.share() == 1);
  return packets;
}

std::string complaint_of(const Octets& bytes) {
  return test::complaint([&] { packets_of(bytes); });
}

Octets pcap_head(std::uint32_t magic, bool big_endian, std::uint32_t link_type) {
  return octets(magic, 4, big_endian) + octets(2, 2, big_endian) + octets(4, 2, big_endian) +
         octets(0, 8, big_endian) + octets(65535, 4, big_endian) + octets(link_type, 4, big_endian);
}

Octets pcap_record(std::uint32_t seconds, std::uint32_t part, const Octets& data, bool big_endian = false) {
  return octets(seconds, 4, big_endian) + octets(part, 4, big_endian) + octets(data.size(), 4, big_endian) +
         octets(data.size(), 4, big_endian) + data;
}

Octets filled_to_four(Octets bytes) {
  while (bytes.size() % 4 != 0) bytes.push_back(0);
  return bytes;
}

/// pcapng, in one byte order.
struct Blocks {
  bool big_endian = false;

  Octets number(std::uint64_t value, int count) const { return octets(value, count, big_endian); }
  Octets block(std::uint32_t type, const Octets& body) const {
    const Octets whole = filled_to_four(body);
    return number(type, 4) + number(whole.size() + 12, 4) + whole + number(whole.size() + 12, 4);
  }
  Octets section() const {
    return block(0x0A0D0D0A, number(0x1A2B3C4D, 4) + number(1, 2) + number(0, 2) + Octets(8, 0xff));
  }
  Octets option(std::uint32_t code, const Octets& value) const {
    return number(code, 2) + number(value.size(), 2) + filled_to_four(value);
  }
  Octets interface(std::uint32_t link_type, const Octets& options = {}) const {
    return block(1, number(link_type, 2) + number(0, 2) + number(0, 4) + options);
  }
  Octets enhanced(std::uint32_t which, std::uint64_t ticks, const Octets& data) const {
    return block(6, number(which, 4) + number(ticks >> 32, 4) + number(ticks & 0xffffffff, 4) +
                        number(data.size(), 4) + number(data.size(), 4) + data);
  }
};

const Octets kData = {1, 2, 3, 4, 5};

}  // namespace

TEST_CASE("a dump is a pcap of raw IP in nanoseconds") {
  const test::TemporaryFolder folder;
  const auto file = folder.path / "dump.pcap";
  CaptureDump dump(file);
  dump.write(1'700'000'000'000'000'007, kData);
  dump.write(1'700'000'001'999'999'999, {});
  dump.flush();
  std::ifstream in(file, std::ios::binary);
  const Octets written{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  CHECK(written == pcap_head(0xa1b23c4d, true, 101) + pcap_record(1700000000, 7, kData, true) +
                       pcap_record(1700000001, 999999999, {}, true));
}

TEST_CASE("a dump that cannot be written is told") {
  CHECK_THROWS_WITH_AS(CaptureDump("/nowhere/dump.pcap"),
                       "/nowhere/dump.pcap: cannot be written: No such file or directory", DeviceError);
  CaptureDump full("/dev/full");
  full.write(0, kData);
  CHECK_THROWS_WITH_AS(full.flush(), "/dev/full: cannot be written", DeviceError);
}

TEST_CASE("pcap: both byte orders, microseconds and nanoseconds") {
  for (const bool big_endian : {false, true})
    for (const bool nano : {false, true}) {
      CAPTURE(big_endian);
      CAPTURE(nano);
      const auto packets =
          packets_of(pcap_head(nano ? 0xa1b23c4d : 0xa1b2c3d4, big_endian, 1) +
                     pcap_record(1700000000, 999999, kData, big_endian) +
                     pcap_record(1700000001, 0, {}, big_endian) + pcap_record(2, 7, {9}, big_endian));
      REQUIRE(packets.size() == 3);
      CHECK(packets[0].time_ns == 1'700'000'000'000'000'000 + (nano ? 999'999 : 999'999'000));
      CHECK(packets[0].bytes == kData);
      CHECK(packets[0].link_type == DLT_EN10MB);
      CHECK(packets[0].interface.empty());
      CHECK(packets[1].bytes.empty());
      CHECK(packets[2].bytes == Octets{9});
    }
}

TEST_CASE("pcap: raw IP is one link type, whatever its number; flags of the header are none") {
  for (const std::uint32_t number : {101U, 228U, 229U, 0x50000065U}) {
    const auto packets = packets_of(pcap_head(0xa1b2c3d4, false, number) + pcap_record(1, 0, kData));
    CHECK(packets.at(0).link_type == DLT_RAW);
  }
  CHECK(packets_of(pcap_head(0xa1b2c3d4, false, 227) + pcap_record(1, 0, kData)).at(0).link_type == 227);
}

TEST_CASE("pcap: cut off at any byte of a packet is told, between packets it is just shorter") {
  const Octets whole = pcap_head(0xa1b2c3d4, false, 1) + pcap_record(1, 0, kData) + pcap_record(2, 0, kData);
  const std::size_t record = 16 + kData.size();
  for (std::size_t size = 24; size < whole.size(); ++size) {
    CAPTURE(size);
    const Octets part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    if ((size - 24) % record == 0)
      CHECK(packets_of(part).size() == (size - 24) / record);
    else
      CHECK(complaint_of(part).find("was cut off, expected a whole capture") != std::string::npos);
  }
  CHECK(complaint_of(Octets(whole.begin(), whole.begin() + 20)).find("was cut off") != std::string::npos);
  CHECK(complaint_of({1, 2, 3}).find("is no capture, expected a pcap or a pcapng") != std::string::npos);
  CHECK(complaint_of({1, 2, 3, 4}).find("is no capture") != std::string::npos);
  CHECK(
      complaint_of(pcap_head(0xa1b2c3d4, false, 1) + octets(0, 8) + octets(17 << 20, 4, false) + octets(0, 4))
          .find("is damaged") != std::string::npos);
}

TEST_CASE("pcapng: interfaces with their names, clocks and offsets, in both byte orders") {
  for (const bool big_endian : {false, true}) {
    CAPTURE(big_endian);
    const Blocks b{big_endian};
    const auto packets =
        packets_of(b.section() + b.interface(1, b.option(2, {'c', 'a', 'n', '0'}) + b.option(0, {})) +
                   b.interface(227, b.option(1, {'?'}) + b.option(9, {9}) + b.option(2, {'e'})) +
                   b.interface(101, b.option(9, {0x80 | 10}) + b.option(14, b.number(100, 8))) +
                   b.block(5, Octets(9)) + b.enhanced(0, 1'700'000'000'000'001, kData) +
                   b.enhanced(1, 5'000'000'007, {7}) + b.enhanced(2, 3 * 1024 + 512, {}));
    REQUIRE(packets.size() == 3);
    CHECK(packets[0].time_ns == 1'700'000'000'000'001'000);  // microseconds, unless it says otherwise
    CHECK(packets[0].interface == "can0");
    CHECK(packets[0].link_type == DLT_EN10MB);
    CHECK(packets[0].bytes == kData);
    CHECK(packets[1].time_ns == 5'000'000'007);
    CHECK(packets[1].interface == "e");
    CHECK(packets[1].link_type == 227);
    CHECK(packets[1].bytes == Octets{7});
    CHECK(packets[2].time_ns == 103'500'000'000);  // of 1024 ticks a second, 100 s later
    CHECK(packets[2].link_type == DLT_RAW);
  }
}

TEST_CASE("pcapng: simple packets have the time of the one before, old ones their own") {
  const Blocks b;
  const Octets old = b.block(2, b.number(0, 2) + b.number(0, 2) + b.number(0, 4) + b.number(3'000'000, 4) +
                                    b.number(kData.size(), 4) + b.number(kData.size(), 4) + kData);
  const auto packets = packets_of(b.section() + b.interface(1) + b.block(3, b.number(5, 4) + kData) + old +
                                  b.block(3, b.number(900, 4) + kData));
  REQUIRE(packets.size() == 3);
  CHECK(packets[0].time_ns == 0);
  CHECK(packets[0].bytes == kData);
  CHECK(packets[1].time_ns == 3'000'000'000);
  CHECK(packets[1].bytes == kData);
  CHECK(packets[2].time_ns == 3'000'000'000);
  CHECK(packets[2].bytes == filled_to_four(kData));  // captured in part: as much as there is
}

TEST_CASE("pcapng: each section has its own interfaces and its own byte order") {
  const Blocks little{false}, big{true};
  const auto packets = packets_of(little.section() + little.interface(1) + little.enhanced(0, 1, {1}) +
                                  big.section() + big.interface(227) + big.enhanced(0, 2, {2}));
  REQUIRE(packets.size() == 2);
  CHECK(packets[0].link_type == 1);
  CHECK(packets[1].link_type == 227);
  CHECK(packets[1].time_ns == 2000);
  CHECK(complaint_of(little.section() + little.interface(1) + big.section() + big.enhanced(0, 2, {2}))
            .find("is damaged") != std::string::npos);
}

TEST_CASE("pcapng: what cannot be is damaged, and what ends early cut off") {
  const Blocks b;
  const Octets begin = b.section() + b.interface(1);
  const auto is_damaged = [&](const Octets& rest) {
    return complaint_of(begin + rest).find("is damaged, expected a whole capture") != std::string::npos;
  };
  CHECK(is_damaged(b.enhanced(1, 0, kData)));    // no such interface
  CHECK(is_damaged(b.block(6, Octets(16, 0))));  // too short
  CHECK(
      is_damaged(b.block(6, Octets(12, 0) + b.number(9, 4) + Octets(4, 0) + Octets(8))));  // more than it has
  CHECK_FALSE(is_damaged(b.block(6, Octets(12, 0) + b.number(8, 4) + Octets(4, 0) + Octets(8))));
  CHECK(is_damaged(b.number(6, 4) + b.number(8, 4)));                // no block is so short
  CHECK(is_damaged(b.number(6, 4) + b.number(33, 4) + Octets(25)));  // nor of such a length
  CHECK(is_damaged(b.number(6, 4) + b.number((16U << 20) + 4, 4)));
  CHECK(is_damaged(b.interface(1, b.option(9, {20}))));
  CHECK(is_damaged(b.interface(1, b.option(9, {0x80 | 64}))));
  CHECK_FALSE(is_damaged(b.interface(1, b.option(9, {19})) + b.interface(1, b.option(9, {0x80 | 63}))));
  CHECK(complaint_of(b.number(0x0A0D0D0A, 4) + b.number(28, 4) + Octets(20)).find("is damaged") !=
        std::string::npos);
  const Octets whole = begin + b.enhanced(0, 0, kData);
  for (std::size_t size = begin.size() + 1; size < whole.size(); ++size)
    CHECK(complaint_of({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)})
              .find("was cut off") != std::string::npos);
}

TEST_CASE("pcap of SocketCAN: a remote request is a classic frame's, CAN FD has none") {
  constexpr std::uint8_t kFd = 4;
  const auto request = [](std::uint8_t flags) {
    return octets(0x40000123, 4, true) + Octets{4, flags, 0, 0} + Octets(4, 0);
  };
  const test::TemporaryFolder folder;
  const LogFile file(folder.write(
      "capture", test::text_of(pcap_head(0xa1b2c3d4, false, DLT_CAN_SOCKETCAN) +
                               pcap_record(1, 0, request(kFd)) + pcap_record(2, 0, request(0)))));
  CanCapture capture(file);
  CanRecord record;
  REQUIRE(capture.next(record));
  CHECK(record.frame.remote);
  CHECK(record.time_ns == 2'000'000'000);
  CHECK_FALSE(capture.next(record));
  CHECK(capture.counts().other == 1);
}

TEST_CASE("pcap of all interfaces: a CAN frame has its length and data, behind the head of the capture") {
  const Octets frame = octets(0x123, 4, true) + Octets{3, 0, 0, 0} + Octets{11, 22, 33};
  const Octets head = Octets(14, 0) + octets(0x000C, 2, true);  // ETH_P_CAN
  const test::TemporaryFolder folder;
  const LogFile file(folder.write("capture", test::text_of(pcap_head(0xa1b2c3d4, false, DLT_LINUX_SLL) +
                                                           pcap_record(1, 0, head + frame))));
  CanCapture capture(file);
  CanRecord record;
  REQUIRE(capture.next(record));
  CHECK(record.frame.id == 0x123);
  REQUIRE(record.frame.size == 3);
  CHECK(Octets(record.frame.data.begin(), record.frame.data.begin() + 3) == Octets{11, 22, 33});
}
