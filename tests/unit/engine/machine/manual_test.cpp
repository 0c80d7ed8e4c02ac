// A signal that a user holds stands, whatever buses and safety rules say.
#include <doctest/doctest.h>

#include "engine/machine/safety_rules.hpp"
#include "rigsound/machine/state_resolver.hpp"

using namespace rigsound;
using namespace rigsound::tests;

namespace {

constexpr SignalId kSecondFeed{Signal::kFeedPressureBar, 1};
constexpr SignalId kSpeed{Signal::kEngineRpm};

}  // namespace

TEST_CASE("a held signal wins over its bus until it is released, and the bus's newest value stands then") {
  SignalBoard board;
  StateResolver resolver;
  const SafetyOptions safety = rules(SafetyAction::kHold, 0);
  board.take({kSecondFeed, 90, Validity::kValid, 0});
  board.hold(kSecondFeed, 200);
  CHECK(resolver.resolve(board, safety, 0).boom[1].feed_pressure_bar == 200);
  board.take({kSecondFeed, 95, Validity::kValid, 0.1});
  const MachineState held = resolver.resolve(board, safety, 0.1);
  CHECK(held.boom[1].feed_pressure_bar == 200);
  CHECK(held.boom[0].feed_pressure_bar == 0);
  CHECK(board.validity(kSecondFeed, safety.rule[0], 0.1) == Validity::kManual);
  board.release(kSecondFeed);
  CHECK(resolver.resolve(board, safety, 0.1).boom[1].feed_pressure_bar == 95);
  CHECK(board.validity(kSecondFeed, safety.rule[0], 0.1) == Validity::kValid);
}

TEST_CASE("a signal that no bus ever said goes back to absent") {
  SignalBoard board;
  StateResolver resolver;
  board.hold({Signal::kPercussion}, 0);
  CHECK(resolver.resolve(board, {}, 0).boom[0].percussion == Percussion::kOff);
  board.release({Signal::kPercussion});
  CHECK(resolver.resolve(board, {}, 0).boom[0].percussion == Percussion::kFromFeed);
}

TEST_CASE("no safety rule acts on a held signal, however old or lost its bus is") {
  SignalBoard board;
  StateResolver resolver;
  const SafetyOptions safety = rules(SafetyAction::kMute, 0);
  board.take({kSecondFeed, 90, Validity::kValid, 0});
  resolver.resolve(board, safety, 0);
  CHECK(resolver.resolve(board, safety, 10).output_gain == 0);  // stale: the rig is mute
  board.hold(kSecondFeed, 120);
  board.take({kSecondFeed, 0, Validity::kBusDown, 11});
  const MachineState state = resolver.resolve(board, safety, 11);
  CHECK(state.output_gain == 1);
  CHECK(state.boom[1].feed_pressure_bar == 120);
}

TEST_CASE("a held speed has no slope, whatever the bus's was") {
  SignalBoard board;
  StateResolver resolver;
  for (int i = 0; i < 50; ++i) board.take({kSpeed, 1000.0 + 10 * i, Validity::kValid, 0.02 * i});
  CHECK(resolver.resolve(board, {}, 1).engine_rpm_slope > 100);
  board.hold(kSpeed, 700);
  const MachineState state = resolver.resolve(board, {}, 1.01);
  CHECK(state.engine_rpm == 700);
  CHECK(state.engine_rpm_slope == 0);
}

TEST_CASE("the state marks what is held, each signal of each boom and of the rig by itself") {
  for_each_signal(kMaxBooms, [](SignalId id) {
    SignalBoard board;
    StateResolver resolver;
    board.hold(id, info(id.signal).max);
    const MachineState state = resolver.resolve(board, {}, 0);
    int marked = 0;
    for_each_signal(kMaxBooms, [&](SignalId other) { marked += is_by_hand(state, other) ? 1 : 0; });
    CHECK(marked == 1);
    CHECK(is_by_hand(state, id));
    CHECK(info(id.signal).get(state, id.boom) == info(id.signal).max);
    board.release(id);
    CHECK_FALSE(is_by_hand(resolver.resolve(board, {}, 0), id));
  });
}

TEST_CASE("a word and its value are each other's, and a range holds what a bus may say") {
  for (const SignalInfo& signal : signal_table()) {
    const Signal s = *signal_by_name(signal.name);
    for (double value = 0; !value_word(s, value).empty(); ++value)
      CHECK(value_of_word(s, value_word(s, value)) == value);
    CHECK_FALSE(value_of_word(s, "neither"));
    for (const double value : {signal.min, signal.max, 0.0, signal.min - 1, signal.max + 1, 1.0})
      CHECK(signal.range().holds(value) == signal.takes(value));
  }
}
