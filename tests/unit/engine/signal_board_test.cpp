#include "rigsound/machine/signal_board.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace rigsound;

namespace {

SafetyOptions rules(SafetyAction action) {
  SafetyOptions options;
  for (SafetyRule& rule : options.rule) rule = {0.5, action};
  options.fade_s = 0.2;
  return options;
}

constexpr SignalId kFeed{Signal::kFeedPressureBar, 0};
constexpr SignalId kRpm{Signal::kEngineRpm, 0};

}  // namespace

TEST_CASE("what was never seen is absent") {
  SignalBoard board(rules(SafetyAction::kMute));
  const MachineState state = board.resolve(10);
  CHECK(state.engine_rpm == 0);
  CHECK(state.engine_load < 0);
  CHECK(state.safety_gain == 1);
  CHECK(state.boom[0].percussion == Percussion::kFromFeed);
  CHECK(state.boom[0].rod_count == 1);
}

TEST_CASE("a reading reaches the boom it is meant for") {
  SignalBoard board(rules(SafetyAction::kHold));
  board.update({Signal::kFeedPressureBar, 1}, 88.5, 0);
  board.update({Signal::kRattling, 0}, 2, 0);
  const MachineState state = board.resolve(0);
  CHECK(state.boom[1].feed_pressure_bar == 88.5f);
  CHECK(state.boom[0].feed_pressure_bar == 0);
  CHECK(state.boom[0].rattling == Rattling::kOpen);
}

TEST_CASE("NaN and values out of range are refused, the last good one stays under `hold`") {
  SignalBoard board(rules(SafetyAction::kHold));
  board.update(kFeed, 90, 0);
  CHECK(board.update(kFeed, std::nan(""), 0.1) == Validity::kOutOfRange);
  CHECK(board.update(kFeed, 301, 0.1) == Validity::kOutOfRange);
  CHECK(board.reading(kFeed, 0.1).validity == Validity::kOutOfRange);
  CHECK(board.resolve(0.1).boom[0].feed_pressure_bar == 90);
  CHECK(board.update(kFeed, 91, 0.2) == Validity::kValid);
  CHECK(board.resolve(5).boom[0].feed_pressure_bar == 91);
}

TEST_CASE("idle: a stale pressure fades to quiet over fade_s and back when it returns") {
  SignalBoard board(rules(SafetyAction::kIdle));
  board.update(kFeed, 100, 0);
  CHECK(board.resolve(0).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.5).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.6).boom[0].feed_pressure_bar == doctest::Approx(50));
  CHECK(board.resolve(0.7).boom[0].feed_pressure_bar == doctest::Approx(0));
  CHECK(board.reading(kFeed, 0.7).validity == Validity::kStale);
  board.update(kFeed, 80, 0.8);
  CHECK(board.resolve(0.8).boom[0].feed_pressure_bar == doctest::Approx(40));
  CHECK(board.resolve(0.9).boom[0].feed_pressure_bar == doctest::Approx(80));
}

TEST_CASE("idle: a diesel goes to its idle speed, and is not started by a broken bus") {
  SignalBoard board(rules(SafetyAction::kIdle));
  board.update(kRpm, 2000, 0);
  board.resolve(0);
  board.resolve(1);
  CHECK(board.resolve(2).engine_rpm == doctest::Approx(800));
  board.update(kRpm, 0, 3);
  board.resolve(3);
  board.resolve(4);
  CHECK(board.resolve(5).engine_rpm == 0);
}

TEST_CASE("mute: the safety gain falls to zero over fade_s and comes back") {
  SignalBoard board(rules(SafetyAction::kMute));
  board.update(kRpm, 900, 0);
  board.resolve(0);
  board.invalidate(kRpm, Validity::kBusDown);
  CHECK(board.resolve(0.1).safety_gain == doctest::Approx(0.5));
  CHECK(board.resolve(0.2).safety_gain == doctest::Approx(0.0));
  CHECK(board.resolve(0.2).engine_rpm == 900);
  board.update(kRpm, 950, 0.3);
  CHECK(board.resolve(0.4).safety_gain == doctest::Approx(1.0));
}

TEST_CASE("stepped signals are rounded and never stand between two values") {
  SignalBoard board(rules(SafetyAction::kIdle));
  board.update({Signal::kRodCount, 0}, 6.7, 0);
  CHECK(board.resolve(0).boom[0].rod_count == 7);
  CHECK(board.resolve(0.55).boom[0].rod_count == 1);
}

TEST_CASE("one bad value between good ones does nothing; bad values for longer than the limit act") {
  SignalBoard board(rules(SafetyAction::kIdle));
  board.update(kFeed, 100, 0);
  board.resolve(0);
  board.invalidate(kFeed, Validity::kNotAvailable);
  CHECK(board.reading(kFeed, 0.4).validity == Validity::kNotAvailable);
  CHECK(board.resolve(0.4).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.5).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.6).boom[0].feed_pressure_bar == doctest::Approx(50));
}

TEST_CASE("where nothing grows stale a bad value acts at once") {
  SafetyOptions options = rules(SafetyAction::kIdle);
  for (SafetyRule& rule : options.rule) rule.stale_after_s = 0;
  SignalBoard board(options);
  board.update(kFeed, 100, 0);
  CHECK(board.resolve(1000).boom[0].feed_pressure_bar == 100);
  board.invalidate(kFeed, Validity::kErrorValue);
  CHECK(board.resolve(1000.1).boom[0].feed_pressure_bar == doctest::Approx(50));
}

TEST_CASE("the value that means absent may be said") {
  SignalBoard board(rules(SafetyAction::kHold));
  const SignalId rate{Signal::kPercussionRateHz, 0};
  CHECK(board.update(rate, 40, 0) == Validity::kValid);
  CHECK(board.update(rate, 3, 0) == Validity::kOutOfRange);
  CHECK(board.update(rate, 0, 0) == Validity::kValid);
  CHECK(board.resolve(0).boom[0].percussion_rate_hz == 0);
}
