#include "rigsound/log/modbus_capture.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "drivers/modbus/bus_harness.hpp"
#include "log/modbus_conversation.hpp"
#include "rigsound/log/can_reader.hpp"
#include "rigsound/log/modbus_capture_writer.hpp"
#include "rigsound/log/modbus_log.hpp"
#include "rigsound/machine/input_error.hpp"
#include "temporary_folder.hpp"
#include "test_data.hpp"

using namespace rigsound;
using test::content;
using namespace rigsound::log;
using modbus::Exchange;
using modbus::Table;
namespace fs = std::filesystem;

namespace {

struct OwnFile {
  OwnFile() : path(fs::temp_directory_path() / ("rigsound_" + std::to_string(::getpid()) + ".pcap")) {}
  ~OwnFile() { fs::remove(path); }
  fs::path path;
};

const std::vector<Exchange> kSaid = {{1, Table::kHolding, true, 0, {855, 0x43F9, 0xB000}},
                                     {1, Table::kHolding, false, 5, {1, 2, 3, 65535}},
                                     {17, Table::kCoil, true, 3, {1, 0, 1, 1, 0, 0, 0, 0, 1}},
                                     {17, Table::kCoil, false, 0, {0, 1}},
                                     {17, Table::kDiscrete, false, 9, {1}},
                                     {255, Table::kInput, false, 100, {7}}};

void write_said(const fs::path& file) {
  ModbusCaptureWriter writer(file);
  for (std::size_t i = 0; i < kSaid.size(); ++i)
    writer.write(1'733'212'800'000'000'000 + static_cast<std::int64_t>(i) * 1'500'000'001, {"", 0}, kSaid[i]);
  writer.flush();
}

modbus::ModbusOptions recorded_device(const char* host, Signal signal) {
  modbus::ModbusOptions options;
  options.role = modbus::Role::kClient;
  options.host = host;
  options.port = 502;
  options.address = std::string(host) + ":502";
  options.routes = {modbus::route(signal, Table::kHolding, 0)};
  return options;
}

std::vector<modbus::ModbusOptions> two_devices() {
  return {recorded_device("10.0.0.1", Signal::kFeedPressureBar),
          recorded_device("10.0.0.2", Signal::kRotationPressureBar)};
}

TcpPacket segment(const std::vector<std::uint8_t>& bytes, std::uint32_t sequence) {
  TcpPacket p;
  p.sequence = sequence;
  p.data = bytes.data();
  p.size = bytes.size();
  return p;
}

}  // namespace

TEST_CASE("What was written as a capture is read as it was, to the nanosecond") {
  const OwnFile file;
  write_said(file.path);
  CHECK(format_of(LogFile(file.path)) == LogFormat::kCapture);
  const LogFile log_file(file.path);
  ModbusCapture capture(log_file);
  TimedExchange got;
  for (std::size_t i = 0; i < kSaid.size(); ++i) {
    REQUIRE(capture.next(got));
    CHECK(got.time_ns == 1'733'212'800'000'000'000 + static_cast<std::int64_t>(i) * 1'500'000'001);
    CHECK(got.exchange.unit == kSaid[i].unit);
    CHECK(got.exchange.table == kSaid[i].table);
    CHECK(got.exchange.written == kSaid[i].written);
    CHECK(got.exchange.address == kSaid[i].address);
    CHECK(got.exchange.values == kSaid[i].values);
  }
  CHECK_FALSE(capture.next(got));
  CHECK(capture.counts().packets == 2 * kSaid.size());
  CHECK(capture.counts().other == 0);
}

TEST_CASE("A capture plays onto the board at its own times") {
  const OwnFile file;
  write_said(file.path);
  modbus::ModbusOptions link;
  link.routes = {modbus::route(Signal::kFeedPressureBar, Table::kHolding, 0, modbus::WordType::kUint16,
                               modbus::WordOrder::kAbcd, 0.1),
                 modbus::route(Signal::kPercussion, Table::kCoil, 1)};
  ModbusLog log(LogFile(file.path), {link}, {});
  SignalBoard board;
  CHECK(log.read_until(0, board));
  CHECK_FALSE(log.read_until(1.4, board));
  CHECK(board.entry({Signal::kFeedPressureBar}).value == doctest::Approx(85.5));
  CHECK(board.entry({Signal::kPercussion}).validity == Validity::kNeverSeen);
  CHECK(*log.next_s() == doctest::Approx(1.5));
  log.read_until(5, board);
  CHECK(board.entry({Signal::kPercussion}).value == 1);
  CHECK(board.entry({Signal::kPercussion}).seen_s == doctest::Approx(4.5));
}

TEST_CASE("Two recorded devices with the same unit stay apart") {
  const OwnFile file;
  {
    ModbusCaptureWriter writer(file.path);
    for (int i = 0; i < 3; ++i) {
      const auto words = [i](int base) {
        return std::vector<std::uint16_t>{static_cast<std::uint16_t>(base + i)};
      };
      writer.write(i, {"10.0.0.1", 502}, {1, Table::kHolding, false, 0, words(10)});
      writer.write(i, {"10.0.0.2", 502}, {1, Table::kHolding, false, 0, words(20)});
    }
    writer.flush();
  }
  ModbusLog log(LogFile(file.path), two_devices(), {});
  SignalBoard board;
  log.read_until(10, board);
  CHECK(board.entry({Signal::kFeedPressureBar}).value == 12);
  CHECK(board.entry({Signal::kRotationPressureBar}).value == 22);
  CHECK_THROWS_AS(ModbusLog(LogFile(file.path), {recorded_device("10.0.0.3", Signal::kFeedPressureBar)}, {}),
                  InputError);
}

TEST_CASE("A device of the rig that a capture of one other does not hold is named") {
  const OwnFile file;
  {
    ModbusCaptureWriter writer(file.path);
    writer.write(0, {"10.0.0.1", 502}, {1, Table::kHolding, false, 0, {10}});
    writer.flush();
  }
  ModbusLog log(LogFile(file.path), two_devices(), {});
  SignalBoard board;
  log.read_until(10, board);
  CHECK(board.entry({Signal::kFeedPressureBar}).value == 10);
  CHECK(board.entry({Signal::kRotationPressureBar}).validity == Validity::kNeverSeen);
  const std::vector<LogNote> notes = log.notes();
  CHECK(std::any_of(notes.begin(), notes.end(), [](const LogNote& note) {
    return note.text == "holds nothing of 10.0.0.2:502, it has 10.0.0.1:502";
  }));
}

TEST_CASE("Streams take repeated, overlapping and lost segments as TCP does") {
  const std::vector<std::uint8_t> frame = {0, 1, 0, 0, 0, 6, 1, 6, 0, 0, 0, 85};
  const std::vector<std::uint8_t> head(frame.begin(), frame.begin() + 7),
      overlap(frame.begin() + 5, frame.end());
  FrameStream stream;
  CHECK(stream.add(segment(head, 1000)));
  CHECK(stream.next().empty());
  CHECK(stream.add(segment(head, 1000)));  // sent again
  CHECK(stream.add(segment(overlap, 1005)));
  CHECK(stream.next() == frame);
  CHECK(stream.next().empty());
  CHECK(stream.add(segment(head, 1012)));
  CHECK(stream.add(segment(frame, 5000)));  // what lay between was not captured
  CHECK(stream.next() == frame);
  CHECK(stream.next().empty());
  CHECK_FALSE(stream.add(segment(std::vector<std::uint8_t>(20, 0xAA), 5012)));
}

TEST_CASE("A segment that comes late fills its gap") {
  const std::vector<std::uint8_t> first = {0, 1, 0, 0, 0, 6, 1, 6, 0, 0, 0, 85},
                                  second = {0, 2, 0, 0, 0, 6, 1, 6, 0, 0, 0, 86},
                                  third = {0, 3, 0, 0, 0, 6, 1, 6, 0, 0, 0, 87};
  FrameStream stream;
  CHECK(stream.add(segment(first, 1000)));
  CHECK(stream.add(segment(third, 1024)));
  CHECK(stream.add(segment(second, 1012)));
  CHECK(stream.add(segment(second, 1012)));  // and once more
  CHECK(stream.next() == first);
  CHECK(stream.next() == third);
  CHECK(stream.next() == second);
  CHECK(stream.next().empty());
}

TEST_CASE("A gap is filled in pieces, and forgotten when it is full or holds no Modbus") {
  const std::vector<std::uint8_t> first = {0, 1, 0, 0, 0, 6, 1, 6, 0, 0, 0, 85},
                                  second = {0, 2, 0, 0, 0, 6, 1, 6, 0, 0, 0, 86},
                                  third = {0, 3, 0, 0, 0, 6, 1, 6, 0, 0, 0, 87};
  const std::vector<std::uint8_t> half(second.begin(), second.begin() + 5),
      rest(second.begin() + 5, second.end());
  FrameStream stream;
  CHECK(stream.add(segment(first, 1000)));
  CHECK(stream.add(segment(third, 1024)));
  CHECK(stream.add(segment(half, 1012)));
  CHECK(stream.next() == first);
  CHECK(stream.next() == third);
  CHECK(stream.next().empty());
  CHECK(stream.add(segment(rest, 1017)));
  CHECK(stream.next() == second);
  CHECK(stream.add(segment(second, 1012)));  // sent again: there is no gap any more
  CHECK(stream.next().empty());

  FrameStream damaged;
  CHECK(damaged.add(segment(first, 1000)));
  CHECK(damaged.add(segment(third, 1036)));
  CHECK_FALSE(damaged.add(segment(std::vector<std::uint8_t>(12, 0xAA), 1012)));
  CHECK(damaged.add(segment(second, 1024)));  // of the gap that was given up
  CHECK(damaged.next() == first);
  CHECK(damaged.next() == third);
  CHECK(damaged.next().empty());
}

TEST_CASE("An RTU frame in a stream gets the head of a TCP frame and loses its checksum") {
  const std::vector<std::uint8_t> rtu = {0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87},
                                  tcp = {0, 0, 0, 0, 0, 6, 0x11, 0x03, 0x00, 0x6B, 0x00, 0x03};
  FrameStream stream(Framing::kRtu);
  std::vector<std::uint8_t> twice = rtu;
  twice.insert(twice.end(), rtu.begin(), rtu.end());
  CHECK(stream.add(segment(twice, 1)));
  CHECK(stream.next() == tcp);
  CHECK(stream.next() == tcp);
  CHECK(stream.next().empty());
  std::vector<std::uint8_t> wrong = rtu;
  wrong.back() ^= 1;
  CHECK_FALSE(stream.add(segment(wrong, 17)));
}

TEST_CASE("A cut-off capture, and what is none, are refused") {
  const OwnFile file;
  write_said(file.path);
  const std::string whole = content(file.path);
  std::ofstream(file.path, std::ios::binary | std::ios::trunc) << whole.substr(0, whole.size() - 5);
  const LogFile log_file(file.path);
  ModbusCapture capture(log_file);
  TimedExchange got;
  CHECK_THROWS_AS(while (capture.next(got)){}, InputError);
  std::ofstream(file.path, std::ios::trunc) << "(0.0) can0 123#00\n";
  CHECK(format_of(LogFile(file.path)) == LogFormat::kCandump);
  CHECK_THROWS_AS(ModbusCapture{LogFile(file.path)}, InputError);
}

TEST_CASE("A capture of a real device: every function, the refusal, the functions that carry no values") {
  const auto file = tests::test_data("a real Modbus capture", "modbus/icsnpp_modbus_example.pcap");
  if (!file) return;
  const LogFile log_file(*file);
  ModbusCapture capture(log_file);
  TimedExchange got;
  int written = 0, read = 0;
  while (capture.next(got)) {
    ++(got.exchange.written ? written : read);
    if (got.exchange.table == Table::kHolding && !got.exchange.written && got.exchange.values.size() == 8)
      CHECK(got.exchange.values ==
            std::vector<std::uint16_t>{0x00aa, 0x00aa, 0x00bb, 0x00cc, 0xef84, 0xe3eb, 0x9f8b, 0xe4c1});
  }
  const CaptureCounts& c = capture.counts();
  CHECK(c.exchanges == static_cast<std::uint64_t>(written + read));
  CHECK(c.exchanges == 18);
  CHECK(c.refused == 1);
  CHECK(c.unpaired == 0);
  CHECK(c.other_functions == 7);
}
