#include "state_exchange.hpp"

#include "live_states.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "rigsound/monotonic_time.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

namespace {

void say(StateExchange& exchange, SignalId id, double value) {
  exchange.change([&](SignalBoard& board) { board.take({id, value, Validity::kValid, monotonic_s()}); });
}

}  // namespace

TEST_CASE("A change is in the next state at once, with the live controls") {
  StateExchange exchange{SafetyOptions{}};
  LiveStates states(exchange.handoff());
  CHECK(states.at(monotonic_s()).engine_rpm == 0);
  say(exchange, {Signal::kEngineRpm}, 1500);
  CHECK(states.at(monotonic_s()).engine_rpm == 1500);
  for (const ControlInfo& control : control_table())
    if (control.name == "decay_factor") exchange.set_control(1, control, 2);
  CHECK(states.at(monotonic_s()).boom[1].controls.decay_factor == 2);
  CHECK(states.at(monotonic_s()).boom[0].controls.decay_factor == 1);
}

TEST_CASE("Mute and gate shut the sound, each by itself") {
  StateExchange exchange{SafetyOptions{}};
  LiveStates states(exchange.handoff());
  exchange.set_muted(true, 0);
  CHECK(states.at(monotonic_s()).output_gain == 0);
  exchange.set_gate(0, 0);
  exchange.set_muted(false, 0);
  CHECK(states.at(monotonic_s()).output_gain == 0);
  exchange.set_gate(1, 0);
  CHECK(states.at(monotonic_s()).output_gain == 1);
}

TEST_CASE("Fades and ageing go on although nobody says anything") {
  SafetyOptions safety;
  for (SafetyRule& rule : safety.rule) rule = {0.5, SafetyAction::kIdle};
  safety.fade_s = 0.2;
  StateExchange exchange{safety};
  LiveStates states(exchange.handoff());
  const double start_s = monotonic_s();
  say(exchange, {Signal::kFeedPressureBar}, 100);
  CHECK(states.at(start_s + 0.1).boom[0].feed_pressure_bar == 100);
  double last = 100;
  for (int block = 0; block < 400; ++block) {
    const double feed =
        static_cast<double>(states.at(start_s + 0.4 + 0.001 * block).boom[0].feed_pressure_bar);
    CHECK(last - feed <= 0.51 + 1e-4);  // 100 bar in 200 blocks of 1 ms, never a step
    last = feed;
  }
  CHECK(last == 0);
  exchange.set_muted(true, 0.1);
  const double muted_s = monotonic_s();
  CHECK(states.at(muted_s + 0.05).output_gain == doctest::Approx(0.5).epsilon(0.05));
  CHECK(states.at(muted_s + 0.2).output_gain == 0);
}

TEST_CASE("A fade moves evenly and ends at its target") {
  OutputFade fade(1);
  fade.start(0, 0.5, 10);
  CHECK(fade.gain(10) == 1);
  CHECK(fade.gain(10.25) == doctest::Approx(0.5));
  fade.start(1, 0.5, 10.25);  // turned round half way
  CHECK(fade.gain(10.25) == doctest::Approx(0.5));
  CHECK(fade.gain(10.5) == doctest::Approx(0.75));
  CHECK(fade.gain(99) == 1);
}

TEST_CASE("New safety rules keep what is known of the signals") {
  StateExchange exchange{SafetyOptions{}};
  say(exchange, {Signal::kEngineRpm}, 1500);
  say(exchange, {Signal::kRodCount, 1}, 4);
  exchange.change([](SignalBoard& board) { board.take({{Signal::kRodCount, 1}, 0, Validity::kBusDown, 0}); });
  exchange.set_safety(SafetyOptions{});
  const SignalBoard board = exchange.board();
  CHECK(board.entry({Signal::kEngineRpm}).value == 1500);
  CHECK(board.entry({Signal::kEngineRpm}).validity == Validity::kValid);
  CHECK(board.entry({Signal::kRodCount, 1}).validity == Validity::kBusDown);
  CHECK(board.entry({Signal::kRock}).validity == Validity::kNeverSeen);
}

// Under the thread sanitizer this shows that buses, main and audio may meet here.
TEST_CASE("Several writers and one reader at once") {
  StateExchange exchange{SafetyOptions{}};
  LiveStates states(exchange.handoff());
  std::atomic<bool> stop{false};
  std::thread control([&] {
    while (!stop) exchange.set_control(0, control_table()[0], 1);
  });
  std::thread bus([&] {
    for (int i = 0; i < 5000; ++i) say(exchange, {Signal::kFeedPressureBar}, i % 300);
    stop = true;
  });
  float seen = 0;
  while (!stop) seen = std::max(seen, states.at(monotonic_s()).boom[0].feed_pressure_bar);
  control.join();
  bus.join();
  CHECK(states.at(monotonic_s()).boom[0].feed_pressure_bar == 199);
  CHECK(seen <= 299);
}
