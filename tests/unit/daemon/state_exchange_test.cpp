#include "state_exchange.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <thread>

#include "monotonic_time.hpp"

using namespace rigsound;
using namespace rigsound::daemon;

TEST_CASE("A change is in the handoff at once, with the live controls") {
  StateExchange exchange{SafetyOptions{}};
  CHECK(exchange.handoff().read().engine_rpm == 0);
  exchange.change([](SignalBoard& board) { board.update({Signal::kEngineRpm}, 1500, monotonic_s()); });
  CHECK(exchange.handoff().read().engine_rpm == 1500);
  DrillControls controls;
  controls.decay_factor = 2;
  exchange.set_controls(1, controls);
  CHECK(exchange.handoff().read().boom[1].controls.decay_factor == 2);
  CHECK(exchange.handoff().read().boom[0].controls.decay_factor == 1);
}

TEST_CASE("Mute and gate shut the sound, each by itself") {
  StateExchange exchange{SafetyOptions{}};
  exchange.set_muted(true, 0);
  CHECK(exchange.handoff().read().safety_gain == 0);
  exchange.set_gate(0, 0);
  exchange.set_muted(false, 0);
  CHECK(exchange.handoff().read().safety_gain == 0);
  exchange.set_gate(1, 0);
  CHECK(exchange.handoff().read().safety_gain == 1);
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
  exchange.change([](SignalBoard& board) {
    board.update({Signal::kEngineRpm}, 1500, monotonic_s());
    board.update({Signal::kRodCount, 1}, 4, monotonic_s());
    board.invalidate({Signal::kRodCount, 1}, Validity::kBusDown);
  });
  exchange.set_safety(SafetyOptions{});
  CHECK(exchange.reading({Signal::kEngineRpm}).value == 1500);
  CHECK(exchange.reading({Signal::kEngineRpm}).validity == Validity::kValid);
  CHECK(exchange.reading({Signal::kRodCount, 1}).validity == Validity::kBusDown);
  CHECK(exchange.reading({Signal::kRock}).validity == Validity::kNeverSeen);
}

// Under the thread sanitizer this shows that buses, main and audio may meet here.
TEST_CASE("Several writers and one reader at once") {
  StateExchange exchange{SafetyOptions{}};
  std::atomic<bool> stop{false};
  std::thread ticker([&] {
    while (!stop) exchange.tick();
  });
  std::thread bus([&] {
    for (int i = 0; i < 5000; ++i)
      exchange.change(
          [&](SignalBoard& board) { board.update({Signal::kEngineRpm}, i % 4000, monotonic_s()); });
    stop = true;
  });
  float seen = 0;
  while (!stop) seen = exchange.handoff().read().engine_rpm;
  ticker.join();
  bus.join();
  CHECK(exchange.handoff().read().engine_rpm == 999);
  CHECK(seen <= 4000);
}
