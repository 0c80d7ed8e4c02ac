// What candump shows on the screen, with any of its options.
#include <cstdint>
#include <string>

#include "drivers/log/format_reader.hpp"

using namespace rigsound;
using test::bytes;
using Reader = test::FormatReader;

TEST_CASE("candump's screen: every way it shows a frame") {
  const Reader r(log::candump_format());
  const std::vector<int> data{0xF0, 0x7D, 0x01};
  for (const char* line :
       {"(1557265716.818982)  can0  123   [3]  F0 7D 01",
        " (1557265716.818982)  can0  123   [3]  F0 7D 01  'x}.'",
        "(1557265716.818982)  can0  RX - -  123   [3]  F0 7D 01",
        "(1557265716.818982) can0 TX B E 123 [3] F0 7D 01", "(1557265716.818982)  can0  123   [3]  01`7D`F0",
        "(1557265716.818982)  can0  123   [3]  11110000 01111101 00000001",
        "(1557265716.818982)  \x1b[32mcan0\x1b[0m  123   [3]  F0 7D 01\r"}) {
    CAPTURE(std::string(line));
    const log::CanRecord record = r.frame(line);
    CHECK(record.time_ns == 1'557'265'716'818'982'000);
    CHECK(record.interface == "can0");
    CHECK(record.frame.id == 0x123);
    CHECK_FALSE(record.frame.fd);
    CHECK(bytes(record.frame) == data);
  }
  CHECK(r.frame("(1.0)  can0  123  [03]  F0 7D 01").frame.fd);
  CHECK_FALSE(r.frame("(1.0)  can0  123  [3]  F0 7D 01").frame.extended);
  CHECK(r.frame("(1.0)  can0  00000123  [0] ").frame.extended);
  CHECK(r.frame("(1.0)  can0  123  [8]  remote request").frame.remote);
  CHECK(r.other("(1.0)  can0  123  [27]  remote request"));  // CAN FD has none
  const can::Frame raw = r.frame("(1.0)  can0  123  {C}  01 02 03 04 05 06 07 08").frame;
  CHECK(raw.size == 8);
}

TEST_CASE("candump's screen: dates, months and leap years are seconds since 1970") {
  const Reader r(log::candump_format());
  struct Date {
    const char* text;
    std::int64_t seconds;
  };
  for (const Date& d : {Date{"1970-01-01 00:00:00", 0},
                        {"1970-01-01 00:01:01", 61},
                        {"2000-02-29 23:59:60", 951868800},
                        {"2000-03-01 00:00:00", 951868800},
                        {"2023-05-10 12:34:56", 1683722096},
                        {"2100-03-01 00:00:00", 4107542400},
                        {"2024-12-31 23:00:00", 1735686000},
                        {"2254-01-31 01:00:00", 8964781200}}) {
    CAPTURE(std::string(d.text));
    CHECK(r.frame("(" + std::string(d.text) + ".5)  can0  123  [0]").time_ns ==
          d.seconds * 1'000'000'000 + 500'000'000);
  }
  for (const char* text :
       {"1969-12-31 00:00:00", "2255-01-01 00:00:00", "2023-00-10 00:00:00", "2023-13-10 00:00:00",
        "2023-01-32 00:00:00", "2023-01-10 24:00:00", "2023-01-10 00:60:00", "2023-01-10 00:00:61",
        "2023-01-1000:00:00", "2023/01/10 00:00:00"}) {
    CAPTURE(std::string(text));
    CHECK(r.other("(" + std::string(text) + ".5)  can0  123  [0]"));
  }
}

TEST_CASE("candump's screen: stamps from frame to frame add up, lines without one are 1 ms apart") {
  const Reader gaps(log::candump_format(log::CandumpStamps::kSinceLastFrame));
  CHECK(gaps.frame("(000.5)  can0  123  [0]").time_ns == 500'000'000);
  CHECK(gaps.frame("(001.5)  can0  123  [0]").time_ns == 2'000'000'000);
  CHECK(gaps.format->remark() == "its stamps count from frame to frame");
  const Reader none(log::candump_format());
  CHECK(none.format->remark().empty());
  CHECK(none.frame("can0  123  [0]").time_ns == 1'000'000);
  CHECK(none.frame("can0  123  [0]").time_ns == 2'000'000);
  CHECK(none.format->remark() == "carries no time stamps: its frames are taken as 1 ms apart");
}

TEST_CASE("candump's screen: anything else is no frame") {
  const Reader r(log::candump_format());
  for (const char* line :
       {"(1.0)  can0  123  [2]  F0", "(1.0)  can0  123  [9]  0 1 2 3 4 5 6 7 8",
        "(1.0)  can0  123  [065]  00", "(1.0)  can0  123  [x]  00", "(1.0)  can0  123  {X}  00",
        "(1.0)  can0  123  {12}  00", "(1.0)  can0  123  [1}  00", "(1.0)  can0  123  [1]  11110002",
        "(1.0)  can0  123  [1]  F", "(1.0)  can0  123  [1]  `F0", "(1.0)  can0  123  [2]  `F0`00",
        "(1.0)  can0  123  [1]  F00", "(1.0)  can0  12G  [1]  00", "(1.0)can0  123  [1]  00", "(1.0) 123#00",
        "can0 123#00"}) {
    CAPTURE(std::string(line));
    CHECK(r.other(line));
  }
  CHECK(r.format->begins_a_frame("(1.0"));
  CHECK(r.format->begins_a_frame("  can0 123 [1]"));
  CHECK_FALSE(r.format->begins_a_frame("can0 123"));
  CHECK_FALSE(r.format->begins_a_frame("   "));
}
