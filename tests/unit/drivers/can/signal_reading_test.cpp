#include "rigsound/can/signal_reading.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <random>

#include "rigsound/can/frame_decoder.hpp"

using namespace rigsound;
using namespace rigsound::can;

namespace {

Frame frame(std::uint32_t id, std::initializer_list<int> bytes) {
  Frame f;
  f.id = id;
  f.extended = id > 0x7FF;
  for (const int b : bytes) f.data[f.size++] = static_cast<std::uint8_t>(b);
  return f;
}

SignalLayout layout(int start, int length, ByteOrder order = ByteOrder::kIntel,
                    ValueType type = ValueType::kUnsigned, double scale = 1, double offset = 0) {
  return {{start, length, order}, type, scale, offset, {}, {}};
}

/// From the definition, bit by bit: Intel counts up from the least significant bit; Motorola goes from the
/// most significant bit down inside a byte and on at bit 7 of the next.
std::optional<std::uint64_t> by_the_definition(const BitField& field, const Frame& f) {
  std::uint64_t raw = 0;
  int position = field.start_bit;
  for (int i = 0; i < field.length; ++i) {
    const int byte = position / 8, bit = position % 8;
    if (byte >= f.size) return std::nullopt;
    const std::uint64_t value = f.data[static_cast<std::size_t>(byte)] >> bit & 1;
    if (field.order == ByteOrder::kIntel) {
      raw += value * (1ULL << i);
      ++position;
    } else {
      raw = raw * 2 + value;
      position = bit > 0 ? position - 1 : position + 15;
    }
  }
  return raw;
}

const SignalLayout kEngineSpeed = layout(24, 16, ByteOrder::kIntel, ValueType::kUnsigned, 0.125);
const MessageMatch kEec1{0x0CF004FE, true, true, {}};

}  // namespace

TEST_CASE("every field of every frame size is what the definition says, and never read past the end") {
  std::mt19937 random(1);
  for (int round = 0; round < 20000; ++round) {
    Frame f;
    f.size = static_cast<std::uint8_t>(random() % 65);
    for (int i = 0; i < f.size; ++i)
      f.data[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(random());
    const BitField field{static_cast<int>(random() % 512), static_cast<int>(random() % 64) + 1,
                         random() % 2 == 0 ? ByteOrder::kIntel : ByteOrder::kMotorola};
    const auto expected = by_the_definition(field, f);
    REQUIRE(extract(field, f) == expected);
  }
}

TEST_CASE("a Motorola field begins at its most significant bit") {
  // 7|16@0: byte 0 is the high byte, byte 1 the low one.
  CHECK(extract({7, 16, ByteOrder::kMotorola}, frame(1, {0x12, 0x34})) == 0x1234);
  // 3|12@0: low nibble of byte 0, then byte 1.
  CHECK(extract({3, 12, ByteOrder::kMotorola}, frame(1, {0xF2, 0x34})) == 0x234);
}

TEST_CASE("signs, floats, scale and offset") {
  const Frame f = frame(1, {0xFE, 0xFF, 0x00, 0x80});
  CHECK(read_signal(layout(0, 16, ByteOrder::kIntel, ValueType::kSigned), RawValues::kAll, f)->value == -2);
  CHECK(read_signal(layout(4, 12, ByteOrder::kIntel, ValueType::kSigned), RawValues::kAll, f)->value == -1);
  CHECK(read_signal(layout(16, 16, ByteOrder::kIntel, ValueType::kSigned, 0.5, 10), RawValues::kAll, f)
            ->value == -16374);
  CHECK(read_signal(layout(8, 8, ByteOrder::kIntel, ValueType::kUnsigned, 0.4, -40), RawValues::kAll, f)
            ->value == doctest::Approx(62));
  Frame floats;
  floats.size = 12;
  const float small = 1.5F;
  const double large = -2.25e10;
  std::memcpy(floats.data.data(), &small, 4);
  std::memcpy(floats.data.data() + 4, &large, 8);
  CHECK(read_signal(layout(0, 32, ByteOrder::kIntel, ValueType::kFloat32), RawValues::kAll, floats)->value ==
        1.5);
  CHECK(read_signal(layout(32, 64, ByteOrder::kIntel, ValueType::kFloat64), RawValues::kAll, floats)->value ==
        -2.25e10);
}

TEST_CASE("check vectors of J1939 engine speed") {
  CHECK(read_signal(kEngineSpeed, RawValues::kJ1939,
                    frame(0x0CF00400, {0xF0, 0x7D, 0x85, 0x9B, 0x0F, 0xFF, 0xFF, 0x85}))
            ->value == 499.375);
  CHECK(read_signal(kEngineSpeed, RawValues::kJ1939, frame(0x0CF00400, {0, 0, 0, 0x20, 0x4E, 0, 0, 0}))
            ->value == 2500);
}

TEST_CASE("raw values that J1939 sets apart are no values") {
  const auto speed = [](int low, int high, RawValues raw_values) {
    return read_signal(kEngineSpeed, raw_values, frame(0x0CF00400, {0, 0, 0, low, high, 0, 0, 0}));
  };
  CHECK(speed(0xFF, 0xFA, RawValues::kJ1939)->value == 8031.875);  // the highest of SPN 190
  CHECK(speed(0x00, 0xFB, RawValues::kJ1939)->validity == Validity::kErrorValue);
  CHECK(speed(0x00, 0xFE, RawValues::kJ1939)->validity == Validity::kErrorValue);
  CHECK(speed(0xFF, 0xFF, RawValues::kJ1939)->validity == Validity::kNotAvailable);
  CHECK(speed(0xFF, 0xFF, RawValues::kAll)->value == 65535 * 0.125);
  const auto load = [](int raw) {
    return read_signal(layout(0, 8), RawValues::kJ1939, frame(0x0CF00400, {raw}))->validity;
  };
  CHECK(load(0xFA) == Validity::kValid);
  CHECK(load(0xFB) == Validity::kErrorValue);
  CHECK(load(0xFF) == Validity::kNotAvailable);
  CHECK(j1939_meaning(2, 1) == Validity::kValid);
  CHECK(j1939_meaning(2, 2) == Validity::kErrorValue);
  CHECK(j1939_meaning(4, 13) == Validity::kValid);
  CHECK(j1939_meaning(4, 15) == Validity::kNotAvailable);
  CHECK(j1939_meaning(10, 0x3FA) == Validity::kValid);
  CHECK(j1939_meaning(10, 0x3FE) == Validity::kErrorValue);
  CHECK(j1939_meaning(12, 0xFAF) == Validity::kValid);
  CHECK(j1939_meaning(12, 0xFF0) == Validity::kNotAvailable);
  CHECK(j1939_meaning(32, 0xFAFFFFFF) == Validity::kValid);
  CHECK(j1939_meaning(32, 0xFE000000) == Validity::kErrorValue);
  CHECK(j1939_meaning(64, ~std::uint64_t{0}) == Validity::kNotAvailable);
  CHECK(j1939_meaning(1, 1) == Validity::kValid);
}

TEST_CASE("a parameter group is matched whatever its priority, source and destination") {
  CHECK(pgn(0x0CF00400) == 61444);
  CHECK(pgn(0x18EF2301) == 0xEF00);
  CHECK(pgn(0x19FA041C) == 0x1FA04);
  CHECK(matches(kEec1, frame(0x0CF00400, {})));
  CHECK(matches(kEec1, frame(0x18F00421, {})));
  CHECK_FALSE(matches(kEec1, frame(0x0CF00300, {})));
  const MessageMatch addressed{0x18EF00FE, true, true, {}};
  CHECK(matches(addressed, frame(0x18EF5533, {})));
  MessageMatch from_21 = kEec1;
  from_21.source = 0x21;
  CHECK(matches(from_21, frame(0x18F00421, {})));
  CHECK_FALSE(matches(from_21, frame(0x0CF00400, {})));
  const MessageMatch plain{0x0CF00400, true, false, {}};
  CHECK(matches(plain, frame(0x0CF00400, {})));
  CHECK_FALSE(matches(plain, frame(0x18F00400, {})));
}

TEST_CASE("remote and error frames, and the other identifier length, carry no message") {
  Frame f = frame(0x123, {1});
  const MessageMatch match{0x123, false, false, {}};
  CHECK(matches(match, f));
  f.extended = true;
  CHECK_FALSE(matches(match, f));
  f.extended = false;
  f.remote = true;
  CHECK_FALSE(matches(match, f));
  f.remote = false;
  f.error = true;
  CHECK_FALSE(matches(match, f));
}

TEST_CASE("a multiplexed signal is there only under its selector") {
  SignalLayout signal = layout(8, 8);
  signal.selectors.push_back({{0, 4, ByteOrder::kIntel}, {{1, 1}, {5, 7}}});
  CHECK(read_signal(signal, RawValues::kAll, frame(1, {0xF1, 42}))->value == 42);
  CHECK(read_signal(signal, RawValues::kAll, frame(1, {0x06, 43}))->value == 43);
  CHECK_FALSE(read_signal(signal, RawValues::kAll, frame(1, {0x02, 44})));
  signal.selectors.push_back({{4, 4, ByteOrder::kIntel}, {{3, 3}}});
  CHECK(read_signal(signal, RawValues::kAll, frame(1, {0x31, 45}))->value == 45);
  CHECK_FALSE(read_signal(signal, RawValues::kAll, frame(1, {0x41, 46})));
  CHECK(read_signal(signal, RawValues::kAll, frame(1, {0x31}))->validity == Validity::kNotAvailable);
}

TEST_CASE("a short frame invalidates the signals that do not fit and updates the others") {
  const SignalId rpm{Signal::kEngineRpm}, load{Signal::kEngineLoad};
  FrameDecoder decoder(
      {{rpm, "EEC1.EngSpeed", kEec1, kEngineSpeed, 0.02},
       {load, "EEC1.Load", kEec1, layout(0, 8, ByteOrder::kIntel, ValueType::kUnsigned, 0.01), 0.02}});
  std::vector<Reading> readings;
  CHECK(decoder.decode(frame(0x0CF00400, {50, 0, 0, 0x20, 0x4E}), 1, readings));
  CHECK(decoder.decode(frame(0x0CF00400, {60, 0, 0, 0x20}), 2, readings));
  CHECK_FALSE(decoder.decode(frame(0x0CF00300, {70, 0, 0, 0x20}), 3, readings));
  REQUIRE(readings.size() == 4);
  CHECK(readings[0].value == 2500);
  CHECK(readings[0].time_s == 1);
  CHECK(readings[2].id.signal == rpm.signal);
  CHECK(readings[2].validity == Validity::kNotAvailable);
  CHECK(readings[3].id.signal == load.signal);
  CHECK(readings[3].value == 0.6);
  CHECK(readings[3].time_s == 2);
}
