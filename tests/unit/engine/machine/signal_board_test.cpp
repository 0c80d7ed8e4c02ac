#include "engine/machine/safety_rules.hpp"
#include "rigsound/machine/state_resolver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

using namespace rigsound;
using namespace rigsound::tests;

namespace {

constexpr SignalId kFeed{Signal::kFeedPressureBar, 0};
constexpr double kFade_s = 0.2;
constexpr SignalId kRpm{Signal::kEngineRpm, 0};

/// A board under its safety rules, as every reader of a bus uses it.
struct Board {
  explicit Board(const SafetyOptions& rules) : safety(rules) {}

  Validity update(SignalId id, double value, double time_s) {
    return board.take({id, value, Validity::kValid, time_s});
  }
  void invalidate(SignalId id, Validity why) {
    board.take({id, 0, why, last_s});
    resolver.resolve(board, safety, last_s);  // the next block hears it
  }
  /// As a loop of short blocks does it: asked whenever something is due on the way.
  MachineState resolve(double now_s) {
    for (; last_s < now_s; last_s += 1e-4)
      if (resolver.due(last_s)) resolver.resolve(board, safety, last_s);
    last_s = now_s;
    return resolver.resolve(board, safety, now_s);
  }
  Validity validity(SignalId id, double now_s) const {
    return board.validity(id, safety.rule[static_cast<std::size_t>(id.signal)], now_s);
  }

  SafetyOptions safety;
  SignalBoard board;
  StateResolver resolver;
  double last_s = 0;
};

}  // namespace

TEST_CASE("what was never seen is absent") {
  Board board(rules(SafetyAction::kMute, kFade_s));
  const MachineState state = board.resolve(10);
  CHECK(state.engine_rpm == 0);
  CHECK(state.engine_load < 0);
  CHECK(state.output_gain == 1);
  CHECK(state.boom[0].percussion == Percussion::kFromFeed);
  CHECK(state.boom[0].rod_count == 1);
}

TEST_CASE("a reading reaches the boom it is meant for") {
  Board board(rules(SafetyAction::kHold, kFade_s));
  board.update({Signal::kFeedPressureBar, 1}, 88.5, 0);
  board.update({Signal::kRattling, 0}, 2, 0);
  const MachineState state = board.resolve(0);
  CHECK(state.boom[1].feed_pressure_bar == 88.5f);
  CHECK(state.boom[0].feed_pressure_bar == 0);
  CHECK(state.boom[0].rattling == Rattling::kOpen);
}

TEST_CASE("NaN and values out of range are refused, the last good one stays under `hold`") {
  Board board(rules(SafetyAction::kHold, kFade_s));
  board.update(kFeed, 90, 0);
  CHECK(board.update(kFeed, std::nan(""), 0.1) == Validity::kOutOfRange);
  CHECK(board.update(kFeed, 601, 0.1) == Validity::kOutOfRange);
  CHECK(board.update(kFeed, -1, 0.1) == Validity::kOutOfRange);
  CHECK(board.board.entry(kFeed).refused == 3);
  CHECK(board.validity(kFeed, 0.1) == Validity::kOutOfRange);
  CHECK(board.resolve(0.1).boom[0].feed_pressure_bar == 90);
  CHECK(board.update(kFeed, 91, 0.2) == Validity::kValid);
  CHECK(board.resolve(5).boom[0].feed_pressure_bar == 91);
}

TEST_CASE("pressures and speed over their range are brought to its end and counted, up to twice") {
  Board board(rules(SafetyAction::kHold, kFade_s));
  CHECK(board.update(kFeed, 340, 0) == Validity::kValid);
  CHECK(board.resolve(0).boom[0].feed_pressure_bar == 300);
  CHECK(board.board.entry(kFeed).clamped == 1);
  CHECK(board.board.entry(kFeed).refused == 0);
  CHECK(board.update({Signal::kFlushing}, 1.5, 0) == Validity::kOutOfRange);  // no pressure: refused aloud
}

TEST_CASE("idle: a stale pressure fades to quiet over fade_s and back when it returns") {
  Board board(rules(SafetyAction::kIdle, kFade_s));
  board.update(kFeed, 100, 0);
  CHECK(board.resolve(0).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.5).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.6).boom[0].feed_pressure_bar == doctest::Approx(50).epsilon(0.02));
  CHECK(board.resolve(0.701).boom[0].feed_pressure_bar == 0);
  CHECK(board.validity(kFeed, 0.7) == Validity::kStale);
  board.resolve(0.8);
  board.update(kFeed, 80, 0.8);
  board.resolver.resolve(board.board, board.safety, 0.8);  // the next block hears it
  CHECK(board.resolve(0.9).boom[0].feed_pressure_bar == doctest::Approx(40).epsilon(0.02));
  CHECK(board.resolve(1.0).boom[0].feed_pressure_bar == doctest::Approx(80).epsilon(0.02));
}

TEST_CASE("idle: a diesel goes to its idle speed, and is not started by a broken bus") {
  Board board(rules(SafetyAction::kIdle, kFade_s));
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
  Board board(rules(SafetyAction::kMute, kFade_s));
  board.update(kRpm, 900, 0);
  board.resolve(0);
  board.invalidate(kRpm, Validity::kBusDown);
  CHECK(board.resolve(0.1).output_gain == doctest::Approx(0.5).epsilon(0.02));
  CHECK(board.resolve(0.2).output_gain == doctest::Approx(0.0).epsilon(0.01));
  CHECK(board.resolve(0.2).engine_rpm == 900);
  board.update(kRpm, 950, 0.3);
  CHECK(board.resolve(0.4).output_gain == doctest::Approx(1.0));
}

TEST_CASE("stepped signals are rounded and never stand between two values") {
  Board board(rules(SafetyAction::kIdle, kFade_s));
  for (const auto& [told, rods] :
       {std::pair(6.45, 6), std::pair(6.5, 7), std::pair(7.49, 7), std::pair(6.7, 7)}) {
    board.update({Signal::kRodCount, 0}, told, 0);
    CHECK(board.resolve(0).boom[0].rod_count == rods);
  }
  CHECK(board.resolve(0.55).boom[0].rod_count == 1);
}

TEST_CASE("one bad value between good ones does nothing; bad values for longer than the limit act") {
  Board board(rules(SafetyAction::kIdle, kFade_s));
  board.update(kFeed, 100, 0);
  board.resolve(0);
  board.invalidate(kFeed, Validity::kNotAvailable);
  CHECK(board.validity(kFeed, 0.4) == Validity::kNotAvailable);
  CHECK(board.resolve(0.4).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.5).boom[0].feed_pressure_bar == 100);
  CHECK(board.resolve(0.6).boom[0].feed_pressure_bar == doctest::Approx(50).epsilon(0.02));
}

TEST_CASE("where nothing grows stale a bad value acts at once") {
  SafetyOptions options = rules(SafetyAction::kIdle, kFade_s);
  for (SafetyRule& rule : options.rule) rule.stale_after_s = 0;
  Board board(options);
  board.update(kFeed, 100, 0);
  CHECK(board.resolve(1000).boom[0].feed_pressure_bar == 100);
  board.invalidate(kFeed, Validity::kErrorValue);
  CHECK(board.resolve(1000.1).boom[0].feed_pressure_bar == doctest::Approx(50).epsilon(0.02));
}

TEST_CASE("the value that means absent may be said") {
  Board board(rules(SafetyAction::kHold, kFade_s));
  const SignalId rate{Signal::kPercussionRateHz, 0};
  CHECK(board.update(rate, 40, 0) == Validity::kValid);
  CHECK(board.update(rate, 3, 0) == Validity::kOutOfRange);
  CHECK(board.update(rate, 0, 0) == Validity::kValid);
  CHECK(board.resolve(0).boom[0].percussion_rate_hz == 0);
}

namespace {

/// Largest difference in cents, over the last two seconds of a ramp of 1000 r/min a second told every 20 ms,
/// between the speed of a punctual bus and of one whose messages arrive up to 7 ms late. `stamped`: with
/// their own time.
double cents_apart(const std::function<double(double, double)>& stamp) {
  Board punctual(SafetyOptions{}), late(SafetyOptions{});
  double worst = 0;
  int told = 0, told_late = 0;
  const auto lateness_s = [](int message) {
    return 0.001 * (message * 5 % 8);
  };  // 0...7 ms, never the same twice
  for (int ms = 0; ms < 3000; ++ms) {
    const double now_s = 0.001 * ms;
    for (; 0.02 * told <= now_s; ++told) punctual.update(kRpm, 800 + 1000 * 0.02 * told, 0.02 * told);
    for (; 0.02 * told_late + lateness_s(told_late) <= now_s; ++told_late) {
      const double sent_s = 0.02 * told_late;
      late.update(kRpm, 800 + 1000 * sent_s, stamp(sent_s, now_s));
    }
    const double a = static_cast<double>(punctual.resolve(now_s).engine_rpm);
    const double b = static_cast<double>(late.resolve(now_s).engine_rpm);
    if (ms > 1000) worst = std::max(worst, std::fabs(1200 * std::log2(a / b)));
  }
  return worst;
}

}  // namespace

TEST_CASE("messages that arrive late with their right time are as good as punctual ones") {
  CHECK(cents_apart([](double sent_s, double) { return sent_s; }) <= 1);
  CHECK(cents_apart([](double, double arrival_s) { return arrival_s; }) >
        3);  // what forgetting the time costs
}

TEST_CASE("the speed goes on between messages, by its slope") {
  Board board(SafetyOptions{});
  for (int i = 0; i <= 50; ++i) board.update(kRpm, 1000 + 20 * i, 0.02 * i);
  const MachineState state = board.resolve(1.01);
  CHECK(static_cast<double>(state.engine_rpm) == doctest::Approx(2010).epsilon(0.001));
  CHECK(static_cast<double>(state.engine_rpm_slope) == doctest::Approx(1000).epsilon(0.02));
}

TEST_CASE("a speed that is no longer believed loses its slope over fade_s; other signals' losses leave it") {
  for (const bool speed_is_lost : {true, false}) {
    CAPTURE(speed_is_lost);
    Board board(rules(SafetyAction::kHold, kFade_s));
    double now_s = 0;
    const auto tell = [&] {
      board.update(kRpm, 1000 + 900 * now_s, now_s);
      for_each_signal(kMaxBooms, [&](SignalId id) {
        if (id.signal != Signal::kEngineRpm) board.update(id, info(id.signal).max, now_s);
      });
    };
    for (int i = 0; i < 50; ++i, now_s += 0.02) tell();
    board.resolve(now_s);
    for_each_signal(kMaxBooms, [&](SignalId id) {
      if ((id.signal == Signal::kEngineRpm) == speed_is_lost)
        board.board.take({id, 0, Validity::kBusDown, now_s});
    });
    board.resolver.resolve(board.board, board.safety, now_s);
    const double half = speed_is_lost ? 0.5 : 1, none = speed_is_lost ? 0 : 1;
    CHECK(static_cast<double>(board.resolve(now_s + kFade_s / 2).engine_rpm_slope) ==
          doctest::Approx(900 * half).epsilon(0.02));
    const MachineState after = board.resolve(now_s + 0.22);
    CHECK(static_cast<double>(after.engine_rpm_slope) ==
          doctest::Approx(900 * none).scale(900).epsilon(0.01));
    const double last_told = 1000 + 900 * (now_s - 0.02);
    CHECK(static_cast<double>(after.engine_rpm) ==
          doctest::Approx(last_told + 900 * 0.24 * none).epsilon(0.001));
  }
}

TEST_CASE("no bus can say what stands for absent, and a word takes its own values only") {
  Board board(rules(SafetyAction::kHold, kFade_s));
  for (const SignalInfo& signal : signal_table()) {
    const SignalId id{*signal_by_name(signal.name)};
    const bool in_range = signal.absent >= signal.min && signal.absent <= signal.max;
    if (!in_range && signal.kind != SignalKind::kNumberOrZero)
      CHECK_MESSAGE(board.update(id, signal.absent, 0) == Validity::kOutOfRange, signal.name);
    if (signal.kind == SignalKind::kWord) CHECK(board.update(id, 0.4, 0) == Validity::kOutOfRange);
  }
  CHECK(board.update({Signal::kPercussion}, 2, 0) == Validity::kOutOfRange);
  CHECK(board.board.entry({Signal::kPercussion}).refused == 3);
  CHECK(board.resolve(0).boom[0].percussion == Percussion::kFromFeed);
}

TEST_CASE("a fade begins when it is seen to be due, however long nobody asked") {
  const SafetyOptions safety = rules(SafetyAction::kIdle, kFade_s);
  SignalBoard board;
  StateResolver resolver;
  board.take({kFeed, 100, Validity::kValid, 0});
  resolver.resolve(board, safety, 0.1);
  CHECK_FALSE(resolver.due(0.4));
  CHECK(resolver.due(0.51));
  CHECK(resolver.resolve(board, safety, 10).boom[0].feed_pressure_bar == 100);
  CHECK(resolver.due(10));
  CHECK(resolver.resolve(board, safety, 10.1).boom[0].feed_pressure_bar == doctest::Approx(50));
}
