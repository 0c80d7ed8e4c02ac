// Two states are the same when every field of them is.
#include "rigsound/machine/machine_state.hpp"

#include <doctest/doctest.h>

#include <type_traits>

using namespace rigsound;

TEST_CASE("a state differs from one that has any field other, and from no copy of itself") {
  MachineState state;
  state.engine_rpm = 1500, state.engine_rpm_slope = 3, state.output_gain = 0.5F;
  state.boom[2].rock = 4;
  CHECK(MachineState(state) == state);
  int fields = 0;
  for_each_field(state, [&](const auto&) { ++fields; });
  CHECK(fields > 4 * 18);
  for (int changed = 0; changed < fields; ++changed) {
    CAPTURE(changed);
    MachineState other = state;
    int i = 0;
    for_each_field(other, [&](auto& field) {
      using Field = std::decay_t<decltype(field)>;
      if (i++ == changed) field = static_cast<Field>(static_cast<double>(field) == 1 ? 0 : 1);
    });
    CHECK(other != state);
    CHECK(state != other);
  }
}

TEST_CASE("states that are equal but not bit by bit are the same") {
  MachineState plus, minus;
  minus.engine_rpm = minus.boom[3].feed_pressure_bar = -0.0F;
  CHECK(plus == minus);
  minus.boom[3].rod_count = 9;
  CHECK(plus != minus);
}
