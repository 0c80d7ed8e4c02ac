#include "rigsound/log/candump.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "drivers/log/format_reader.hpp"
#include "log/can_lines.hpp"
#include "log/line_reader.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::test;
using log::CanLine;

namespace {

log::CanRecord parsed(std::string_view line) {
  log::CanRecord record;
  INFO(line);
  REQUIRE(log::candump_format()->parse(line, record) == CanLine::kFrame);
  return record;
}

CanLine kind(std::string_view line) {
  log::CanRecord record;
  return log::candump_format()->parse(line, record);
}

}  // namespace

TEST_CASE("a classic frame: time, interface, identifier, data") {
  const log::CanRecord record = parsed("(1557265716.818982) can0 0CFF0686#F22700F2FFFFFF5F");
  CHECK(record.time_ns == 1557265716818982000);
  CHECK(record.interface == "can0");
  CHECK(record.frame.id == 0x0CFF0686);
  CHECK(record.frame.extended);
  CHECK_FALSE(record.frame.fd);
  CHECK(bytes(record.frame) == std::vector<int>{0xF2, 0x27, 0x00, 0xF2, 0xFF, 0xFF, 0xFF, 0x5F});
}

TEST_CASE("what candump and its users vary in one line") {
  CHECK(parsed("(0.123456789) vcan1 123#").time_ns == 123456789);
  CHECK_FALSE(parsed("(1.000000) can0 123#00").frame.extended);
  CHECK(bytes(parsed("(1.000000)   can0   123#de.ad.BE.ef").frame) ==
        std::vector<int>{0xDE, 0xAD, 0xBE, 0xEF});
  CHECK(bytes(parsed("(1.000000) can0 123#0102 R\r").frame) == std::vector<int>{1, 2});
  CHECK(bytes(parsed("(1.000000) can0 123#0102  T").frame) == std::vector<int>{1, 2});
  CHECK(parsed("(1.000000) can0 123#0011223344556677_F").frame.raw_dlc == 15);
}

TEST_CASE("remote, FD and error frames") {
  const can::Frame remote = parsed("(1.000000) can0 00000123#R8_A").frame;
  CHECK(remote.remote);
  CHECK(remote.extended);
  CHECK(remote.size == 8);
  CHECK(remote.raw_dlc == 10);
  CHECK(parsed("(1.000000) can0 123#r").frame.size == 0);

  const can::Frame fd = parsed("(1.000000) can0 123##5" + std::string(128, 'a')).frame;
  CHECK(fd.fd);
  CHECK(fd.bit_rate_switch);
  CHECK_FALSE(fd.error_passive);
  CHECK(fd.size == 64);
  CHECK(parsed("(1.000000) can0 123##2").frame.error_passive);

  const can::Frame error = parsed("(1.000000) can0 20000080#0000000000000000").frame;
  CHECK(error.error);
  CHECK(error.id == 0x80);
}

TEST_CASE("a CAN XL frame is known and not used") {
  CHECK(kind("(1.000000) can0 00123#81:00:12345678#11223344") == CanLine::kXl);
}

TEST_CASE("anything else is no frame") {
  for (const char* line : {"",
                           "# a comment",
                           "DROPCOUNT: dropped 3 CAN frames",
                           "(1.000000)",
                           "(1.000000) can0",
                           "(1.000000) can0 123",
                           "(1.) can0 123#00",
                           "(1.1234567890) can0 123#00",
                           "(1,000000) can0 123#00",
                           "1.000000 can0 123#00",
                           "(1.000000) can0 123#0",
                           "(1.000000) can0 123#001122334455667788",
                           "(1.000000) can0 123#00_F",
                           "(1.000000) can0 123#0011223344556677_8",
                           "(1.000000) can0 1234#00",
                           "(1.000000) can0 800#00",
                           "(1.000000) can0 80000000#00",
                           "(1.000000) can0 12G#00",
                           "(1.000000) can0 123#R9",
                           "(1.000000) can0 123#00 X",
                           "(1.000000) can0 123#00 R T",
                           "(1.000000) averyveryverylonginterface 123#00",
                           "(99999999999.000000) can0 123#00",
                           "(9552765716.818982) can0 123#00"}) {
    INFO(line);
    CHECK(kind(line) == CanLine::kOther);
  }
  CHECK(kind("(1.000000) can0 123##0" + std::string(130, '0')) == CanLine::kOther);
}

TEST_CASE("what we write is upper case with six decimals and reads back the same") {
  const char* lines[] = {"(1557265716.818982) can0 0CFF0686#F22700F2FFFFFF5F",
                         "(0000000007.000001) can0 7FF#",
                         "(1557265716.818982) can0 123#R",
                         "(1557265716.818982) can0 123#R8_A",
                         "(1557265716.818982) can0 123#0011223344556677_F",
                         "(1557265716.818982) can0 20000080#0000000000000000",
                         "(1557265716.818982) can0 00000123##511223344"};
  for (const char* line : lines) CHECK(log::candump_line(parsed(line)) == line);
  CHECK(log::candump_line(parsed("(1.123456789) can0 7bc#de.ad R")) == "(0000000001.123456) can0 7BC#DEAD");
}

TEST_CASE("a reader counts what it skips and keeps the order of the file") {
  TemporaryFolder folder;
  const log::LogFile file(folder.write("a.log",
                                       "# rig 7\n(2.000000) can0 123#01\n\n(1.000000) can0 123#02\r\n"
                                       "(1.000000) can0 00123#81:00:12345678#11\n" +
                                           std::string(20000, 'x') + "\n(3.000000) can0 20000001#00"));
  log::LineReader reader(file, log::candump_format());
  log::CanRecord record;
  std::vector<std::int64_t> times;
  while (reader.next(record)) times.push_back(record.time_ns / 1000000000);
  CHECK(times == std::vector<std::int64_t>{2, 1, 3});
  CHECK(reader.counts().frames == 3);
  CHECK(reader.counts().error_frames == 1);
  CHECK(reader.counts().xl == 1);
  CHECK(reader.counts().other == 3);
}

TEST_CASE("a log that was cut off is refused with its last line") {
  TemporaryFolder folder;
  const auto read = [&](std::string_view text) {
    const auto file = folder.write("a.log", text);
    return complaint([&] {
      const auto reader = log::open_can_reader(log::LogFile(file));
      log::CanRecord record;
      while (reader->next(record)) continue;
    });
  };
  const std::string whole = "(1.000000) can0 123#0011\n(2.000000) can0 123#0022";
  CHECK(read(whole) == "");
  CHECK(read(whole + "\n") == "");
  CHECK(read(whole + "\n# end") == "");
  for (std::size_t cut = 1; cut < 25; ++cut) {  // everywhere inside the second line
    INFO(cut);
    const std::string expected = cut == 24 ? "" : "a.log:2: the log ends in the middle of a frame";
    const std::string said = read(whole.substr(0, 25 + cut));
    CHECK(said.find(expected) != std::string::npos);
    CHECK(said.empty() == expected.empty());
  }
}

TEST_CASE("a log that is not there is refused") {
  CHECK_THROWS_AS(log::LogFile("/nonexistent.log"), InputError);
  CHECK_THROWS_AS(log::LogFile("/"), InputError);
}
