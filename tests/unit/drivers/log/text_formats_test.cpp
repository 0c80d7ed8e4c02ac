// Lines of Vector ASC and PEAK TRC, as their tools write them.
#include <string>
#include <vector>

#include "drivers/log/format_reader.hpp"

using namespace rigsound;
using test::bytes;
using Reader = test::FormatReader;

namespace {

Reader asc(const std::vector<std::string>& before = {}) { return Reader(log::asc_format(), before); }
Reader trc(const std::string& version) { return Reader(log::trc_format(), {";$FILEVERSION=" + version}); }

}  // namespace

TEST_CASE("ASC: a classic frame, its channel, direction, identifier and bytes") {
  const log::CanRecord r =
      asc().frame("   0.010000 1  CF00400x        Rx   d 8 F0 7D 85 9B 0F FF FF 85  Length = 0 BitCount = 0");
  CHECK(r.time_ns == 10'000'000);
  CHECK(r.interface == "can0");
  CHECK(r.frame.id == 0x0CF00400);
  CHECK(r.frame.extended);
  CHECK_FALSE(r.frame.fd);
  CHECK_FALSE(r.frame.remote);
  CHECK(bytes(r.frame) == std::vector<int>{0xF0, 0x7D, 0x85, 0x9B, 0x0F, 0xFF, 0xFF, 0x85});
  const log::CanRecord tx = asc().frame("1.5 255 7FF Tx d 1 0A \r");
  CHECK(tx.interface == "can254");
  CHECK_FALSE(tx.frame.extended);
  CHECK(tx.frame.id == 0x7FF);
  CHECK(asc().frame("1.5 1 1FFFFFFFX Rx d 0").frame.id == 0x1FFFFFFF);
  CHECK(bytes(asc().frame("1.5 1 123 Rx d C 1 2 3 4 5 6 7 8").frame).size() == 8);  // code 12: 8 bytes
}

TEST_CASE("ASC: remote and error frames") {
  const can::Frame remote = asc().frame("0.1 1 123 Rx r 4").frame;
  CHECK(remote.remote);
  CHECK(remote.size == 4);
  CHECK(asc().frame("0.1 1 123 Rx r").frame.size == 0);
  CHECK(asc().frame("0.1 2 ErrorFrame").frame.error);
  CHECK(asc().frame("0.1 CANFD 2 Rx ErrorFrame Not Acknowledge").interface == "can1");
  CHECK(asc().frame("0.1 CANFD 2 Rx ErrorFrame Not Acknowledge").frame.error);
}

TEST_CASE("ASC: CAN FD lines, with a name and without; the flags say whether it was an FD frame") {
  const std::string flags = " 130000 130 203000 0 0";
  const can::Frame fd = asc().frame("0.1 CANFD 3 Tx 123x 1 0 9 12 1 2 3 4 5 6 7 8 9 A B C" + flags).frame;
  CHECK(fd.fd);
  CHECK(fd.extended);
  CHECK(fd.bit_rate_switch);
  CHECK_FALSE(fd.error_passive);
  CHECK(bytes(fd) == std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const can::Frame named = asc().frame("0.1 CANFD 3 Rx 123 Engine 0 1 2 2 AA BB" + flags).frame;
  CHECK(bytes(named) == std::vector<int>{0xAA, 0xBB});
  CHECK(named.error_passive);
  CHECK_FALSE(named.bit_rate_switch);
  const can::Frame classic = asc().frame("0.1 CANFD 3 Rx 123 1 1 2 2 AA BB 130000 130 200000 0").frame;
  CHECK_FALSE(classic.fd);
  CHECK_FALSE(classic.bit_rate_switch);
  CHECK_FALSE(classic.error_passive);
  CHECK(asc().frame("0.1 CANFD 3 Rx 123 0 0 2 2 AA BB").frame.fd);  // without flags
}

TEST_CASE("ASC: the header chooses the base of numbers and what stamps count from") {
  const Reader decimal = asc({"base dec  timestamps absolute"});
  CHECK(decimal.frame("2.0 1 100 Rx d 2 255 10").frame.id == 100);
  CHECK(bytes(decimal.frame("2.0 1 100 Rx d 2 255 10").frame) == std::vector<int>{255, 10});
  CHECK(decimal.frame("3.0 1 100 Rx d 0").time_ns == 3'000'000'000);
  const Reader relative = asc({"base hex  timestamps relative"});
  CHECK(relative.frame("2.0 1 100 Rx d 0").time_ns == 2'000'000'000);
  CHECK(relative.frame("3.0 1 100 Rx d 0").time_ns == 5'000'000'000);
  CHECK(relative.frame("0.5 1 100 Rx d 0").frame.id == 0x100);
  CHECK(relative.frame("9000000000 1 100 Rx d 0").time_ns == 9'000'000'000 * 1'000'000'000);
}

TEST_CASE("ASC: anything else is no frame") {
  for (const char* line : {"",
                           "date Wed May 10 12:00:00 2023",
                           "Begin Triggerblock",
                           "0.1 Start of measurement",
                           "0.1 1 123 TxRq d 1 00",
                           "0.1 1 800 Rx d 1 00",
                           "0.1 1 20000000x Rx d 1 00",
                           "0.1 1 x Rx d 1 00",
                           "0.1 1 12G Rx d 1 00",
                           "0.1 256 123 Rx d 1 00",
                           "0.1 1 123 Rx d 2 00",
                           "0.1 1 123 Rx d 1 100",
                           "0.1 1 123 Rx e 1 00",
                           "0.1 1 123 Rx d G 00",
                           "x 1 123 Rx d 1 00",
                           "0.1 CANFD x Rx 123 0 0 1 1 00",
                           "0.1 CANFD 1 Xx 123 0 0 1 1 00",
                           "0.1 CANFD 1 Rx 800 0 0 1 1 00",
                           "0.1 CANFD 1 Rx 123 N 0 2 1 1 00",
                           "0.1 CANFD 1 Rx 123 0 0 1 65 00",
                           "0.1 CANFD 1 Rx 123 0 0 1 2 00",
                           "0.1 CANFD 1 Rx 123 0 0 9 9 1 2 3 4 5 6 7 8 9 0 0 0",
                           "0.1 CANFD 1 Rx 123 0 0 1"}) {
    CAPTURE(std::string(line));
    CHECK(asc().other(line));
  }
}

TEST_CASE("ASC: a line begins a frame when it has a stamp and a channel, and tells no statistic") {
  for (const char* line : {"0.1 1 123", "0.1 CANFD 1", "0.1 255 1 Rx"}) {
    CAPTURE(std::string(line));
    CHECK(asc().format->begins_a_frame(line));
  }
  for (const char* line :
       {"", "0.1", "0.1 1", "0.1 1 Statistic: D 0", "x 1 123", "0.1 256 123", "0.1 x 123"}) {
    CAPTURE(std::string(line));
    CHECK_FALSE(asc().format->begins_a_frame(line));
  }
}

TEST_CASE("TRC: every version has its columns") {
  struct Line {
    const char *version, *text, *interface;
  };
  for (const Line& l : {Line{"1.0", "  1)  1059.9 0300 2 00 5A", "can0"},
                        {"1.1", "1) 1059.9 Rx 0300 2 00 5A", "can0"},
                        {"1.2", "1) 1059.9 2 Tx 0300 2 00 5A", "can1"},
                        {"1.3", "1) 1059.9 2 Rx 0300 - 2 00 5A", "can1"},
                        {"2.0", "1 1059.9 DT 0300 Rx 2 00 5A", "can0"},
                        {"2.1", "1 1059.9 DT 3 0300 Rx - 2 00 5A", "can2"}}) {
    CAPTURE(l.version);
    const log::CanRecord r = trc(l.version).frame(l.text);
    CHECK(r.time_ns == 1'059'900'000);
    CHECK(r.interface == l.interface);
    CHECK(r.frame.id == 0x300);
    CHECK_FALSE(r.frame.extended);
    CHECK(bytes(r.frame) == std::vector<int>{0, 0x5A});
  }
}

TEST_CASE("TRC: named columns stand where the header says") {
  const Reader r(log::trc_format(), {";$FILEVERSION=2.1", ";$COLUMNS=N,O,T,B,I,d,R,L,D"});
  const log::CanRecord record = r.frame("7 2.5 FB 2 18EF4AEF Tx - 9 1 2 3 4 5 6 7 8 9 A B C \r");
  CHECK(record.time_ns == 2'500'000);
  CHECK(record.interface == "can1");
  CHECK(record.frame.extended);
  CHECK(record.frame.id == 0x18EF4AEF);
  CHECK(record.frame.fd);
  CHECK(record.frame.bit_rate_switch);
  CHECK_FALSE(record.frame.error_passive);
  CHECK(bytes(record.frame).size() == 12);  // length code 9
  const Reader lengths(log::trc_format(), {";$COLUMNS=N,O,T,I,d,l,D"});
  CHECK(bytes(lengths.frame("7 2.5 FD 0123 Rx 12 1 2 3 4 5 6 7 8 9 A B C").frame).size() == 12);
  const Reader without_time(log::trc_format(), {";$COLUMNS=N,T,I,d,l,D"});
  CHECK(without_time.other("7 DT 0123 Rx 1 00"));
  const Reader without_id(log::trc_format(), {";$COLUMNS=N,O,T,d,l,D"});
  CHECK(without_id.other("7 1.0 DT Rx 1 00"));
  const Reader without_data(log::trc_format(), {";$COLUMNS=N,O,T,I,d,l"});
  CHECK(without_data.other("7 1.0 DT 0123 Rx 0"));
}

TEST_CASE("TRC: kinds of frames") {
  const Reader r = trc("2.0");
  const auto frame = [&](const std::string& type) {
    return r.frame("1 1.0 " + type + " 0123 Rx 1 00").frame;
  };
  CHECK_FALSE(frame("DT").fd);
  CHECK(frame("FD").fd);
  CHECK_FALSE(frame("FD").bit_rate_switch);
  CHECK(frame("FE").error_passive);
  CHECK_FALSE(frame("FE").bit_rate_switch);
  CHECK(frame("BI").error_passive);
  CHECK(frame("BI").bit_rate_switch);
  CHECK(frame("BI").fd);
  const can::Frame remote = r.frame("1 1.0 RR 0123 Rx 4").frame;
  CHECK(remote.remote);
  CHECK(remote.size == 4);
  CHECK_FALSE(remote.fd);
  CHECK(trc("1.1").frame("1) 1.0 Rx 0123 4 RTR").frame.remote);
  CHECK(trc("1.1").frame("1) 1.0 Rx 0123 9 1 2 3 4 5 6 7 8").frame.size == 8);  // a classic frame's code 9
}

TEST_CASE("TRC: anything else is no frame") {
  for (const char* line :
       {"", ";   a comment", "1 1.0 ST 0123 Rx 4 00 00 00 00", "1 1.0 DT 0123 Warn 1 00",
        "1 x DT 0123 Rx 1 00", "1 1.0 DT 0800 Rx 1 00", "1 1.0 DT 20000000 Rx 1 00", "1 1.0 DT 0123 Rx x 00",
        "1 1.0 FD 0123 Rx 4 RTR", "1 1.0 DT 0123 Rx 65 00", "1 1.0 DT 0123 Rx 2 00", "1 1.0 DT 0123"}) {
    CAPTURE(std::string(line));
    CHECK(trc("2.0").other(line));
  }
  CHECK(trc("1.1").other("1) 1.0 Rx 0123 16 00"));
  CHECK(trc("2.0").format->begins_a_frame("1 1.0"));
  CHECK_FALSE(trc("2.0").format->begins_a_frame("1 x DT"));
  CHECK_FALSE(trc("2.0").format->begins_a_frame("1"));
  CHECK_FALSE(trc("2.0").format->begins_a_frame("; 1.0 DT"));
}
