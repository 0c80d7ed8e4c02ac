// Nothing but a valid value moves the machine: every signal, every bit length, every raw value of the short
// ones.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "rigsound/can/frame_decoder.hpp"
#include "rigsound/machine/state_resolver.hpp"

using namespace rigsound;
using namespace rigsound::can;

namespace {

constexpr std::uint32_t kId = 0x18FF1000;

std::uint64_t ones(int length) { return length == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << length) - 1; }

/// Every raw value of up to 12 bits; of longer ones those at both ends and where the top byte changes.
std::vector<std::uint64_t> raw_values(int length) {
  std::set<std::uint64_t> raws;
  if (length <= 12) {
    for (std::uint64_t raw = 0; raw <= ones(length); ++raw) raws.insert(raw);
    return {raws.begin(), raws.end()};
  }
  for (std::uint64_t top = 0; top < 256; ++top)
    for (const std::uint64_t rest :
         {std::uint64_t{0}, std::uint64_t{1}, ones(length - 8) - 1, ones(length - 8)})
      raws.insert(top << (length - 8) | rest);
  for (std::uint64_t small = 0; small < 512; ++small) raws.insert(small);
  return {raws.begin(), raws.end()};
}

/// J1939-71, table 1, as a list for the lengths that it names.
bool set_apart(int length, std::uint64_t raw) {
  switch (length) {
    case 2:
      return raw == 0b10 || raw == 0b11;
    case 4:
      return raw == 0b1110 || raw == 0b1111;
    case 8:
      return raw >= 0xFB;
    case 16:
      return raw >= 0xFB00;
    case 32:
      return raw >= 0xFB000000;
    default:
      return length > 1 && raw == ones(length);  // at any length, all ones is "not available"
  }
}

Frame frame_with(std::uint64_t raw) {
  Frame f;
  f.id = kId;
  f.extended = true;
  f.size = 8;
  for (int i = 0; i < 8; ++i) f.data[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(raw >> (8 * i));
  return f;
}

FrameDecoder decoder_of(SignalId id, int length, bool j1939, double scale) {
  SignalRoute route;
  route.target = id;
  route.match = {kId, true, j1939, {}};
  route.layout.field = {0, length, ByteOrder::kIntel};
  route.layout.scale = scale;
  return FrameDecoder({route});
}

SafetyOptions strict_rules() {
  SafetyOptions safety;
  safety.fade_s = 0;
  for (SafetyRule& rule : safety.rule) rule = {0, SafetyAction::kIdle};
  return safety;
}

/// What the machine is told when the field holds `raw`, after nothing else.
struct Understood {
  Validity validity;
  double value;
};
Understood understood(SignalId id, const FrameDecoder& decoder, std::uint64_t raw) {
  SignalBoard board;
  std::vector<Reading> readings;
  if (!decoder.decode(frame_with(raw), 1, readings)) FAIL("no message");
  for (const Reading& reading : readings) board.take(reading);
  StateResolver resolver;
  const MachineState state = resolver.resolve(board, strict_rules(), 1);
  return {board.entry(id).validity, info(id.signal).get(state, id.boom)};
}

}  // namespace

TEST_CASE("no field of a J1939 message moves the machine with a raw value that is set apart") {
  for (int s = 0; s < kSignalCount; ++s) {
    const SignalId id{static_cast<Signal>(s)};
    const SignalInfo& signal = info(id.signal);
    CAPTURE(signal.name);
    for (int length = 1; length <= 64; ++length) {
      CAPTURE(length);
      // As it comes, and with the scale that brings all of the field into the signal's range.
      for (const double scale : {1.0, signal.max / static_cast<double>(ones(length))}) {
        const FrameDecoder decoder = decoder_of(id, length, true, scale == 0 ? -1e-3 : scale);
        for (const std::uint64_t raw : raw_values(length)) {
          const Understood machine = understood(id, decoder, raw);
          if (set_apart(length, raw)) {
            const bool no_value =
                machine.validity == Validity::kErrorValue || machine.validity == Validity::kNotAvailable;
            if (!no_value) FAIL_CHECK("raw " << raw << " is " << name(machine.validity));
          }
          if (machine.validity != Validity::kValid && machine.value != signal.idle &&
              machine.value != signal.absent)
            FAIL_CHECK("raw " << raw << " is no value, but the machine is told " << machine.value);
        }
      }
    }
  }
}

TEST_CASE("no bus delivers a marker of the engine's, and a word takes its own values only") {
  for (int s = 0; s < kSignalCount; ++s) {
    const SignalId id{static_cast<Signal>(s)};
    const SignalInfo& signal = info(id.signal);
    CAPTURE(signal.name);
    for (int length = 1; length <= 64; ++length) {
      const FrameDecoder decoder = decoder_of(id, length, false, 1);
      for (const std::uint64_t raw : raw_values(length)) {
        const Understood machine = understood(id, decoder, raw);
        const auto value = static_cast<double>(raw);
        const bool clamps = signal.kind == SignalKind::kClampedNumber && value <= 2 * signal.max;
        const bool good = signal.takes(value) || clamps;
        const bool as_it_should = good ? machine.validity == Validity::kValid &&
                                             machine.value == static_cast<float>(std::min(value, signal.max))
                                       : machine.validity == Validity::kOutOfRange;
        if (!as_it_should)
          FAIL_CHECK("raw " << raw << " of " << length << " bits is " << name(machine.validity) << ", told "
                            << machine.value);
      }
    }
    SignalBoard board;
    if (!signal.takes(signal.absent))
      CHECK(board.take({id, signal.absent, Validity::kValid, 0}) == Validity::kOutOfRange);
  }
}

TEST_CASE("what the signal map names overrules J1939") {
  SignalRoute route;
  route.target = {Signal::kRattling};
  route.match = {kId, true, true, {}};
  route.layout.field = {0, 2, ByteOrder::kIntel};
  route.layout.codes = {{2, Validity::kValid}, {3, Validity::kNotAvailable}};
  const FrameDecoder decoder({route});
  CHECK(understood(route.target, decoder, 2).value == static_cast<double>(Rattling::kOpen));
  CHECK(understood(route.target, decoder, 3).validity == Validity::kNotAvailable);
  route.layout.codes.clear();
  CHECK(understood(route.target, FrameDecoder({route}), 2).validity == Validity::kErrorValue);
}

TEST_CASE("an error from the first message on is no reason to fall back on what absence means") {
  const SignalId percussion{Signal::kPercussion};
  const FrameDecoder decoder = decoder_of(percussion, 2, true, 1);
  const Understood machine = understood(percussion, decoder, 0b10);
  CHECK(machine.validity == Validity::kErrorValue);
  CHECK(machine.value == static_cast<double>(Percussion::kOff));  // not kFromFeed, which would hammer
}
