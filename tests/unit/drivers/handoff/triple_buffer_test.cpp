#include "rigsound/handoff/triple_buffer.hpp"

#include <doctest/doctest.h>

#include <thread>

#include "rigsound/machine/machine_state.hpp"

using namespace rigsound;

TEST_CASE("The reader sees the newest value, again and again until there is a newer one") {
  TripleBuffer<int> buffer(1);
  CHECK(buffer.read() == 1);
  buffer.write(2);
  buffer.write(3);
  CHECK(buffer.read() == 3);
  CHECK(buffer.read() == 3);
  buffer.write(4);
  CHECK(buffer.read() == 4);
}

// Also run under the thread sanitizer, where a torn or racing value would be reported as such.
TEST_CASE("Values are whole and never go backwards while both threads run freely") {
  MachineState initial;
  TripleBuffer<MachineState> buffer(initial);
  constexpr int kLast = 200000;
  std::thread writer([&] {
    for (int i = 1; i <= kLast; ++i) {
      MachineState state;
      state.engine_rpm = static_cast<float>(i);
      for (BoomState& boom : state.boom) boom.controls.decay_factor = static_cast<float>(i);
      buffer.write(state);
    }
  });
  float last = 0;
  bool whole = true, forward = true;
  while (last < kLast) {
    const MachineState& state = buffer.read();
    forward = forward && state.engine_rpm >= last;
    last = state.engine_rpm;
    for (const BoomState& boom : state.boom)
      whole = whole && (last == 0 || boom.controls.decay_factor == last);
  }
  writer.join();
  CHECK(whole);
  CHECK(forward);
}
