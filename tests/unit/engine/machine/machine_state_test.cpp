// Two states are the same when every field of them is.
#include "rigsound/machine/machine_state.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "engine/machine/other_fields.hpp"

using namespace rigsound;

TEST_CASE("a state differs from one that has any field other, and from no copy of itself") {
  MachineState state;
  state.engine_rpm = 1500, state.engine_rpm_slope = 3, state.output_gain = 0.5F;
  state.boom[2].rock = 4;
  CHECK(MachineState(state) == state);
  const std::vector<MachineState> others = tests::with_one_field_other(state);
  CHECK(others.size() > 4 * 18);
  for (std::size_t changed = 0; changed < others.size(); ++changed) {
    CAPTURE(changed);
    CHECK(others[changed] != state);
    CHECK(state != others[changed]);
  }
}

TEST_CASE("states that are equal but not bit by bit are the same") {
  MachineState plus, minus;
  minus.engine_rpm = minus.boom[3].feed_pressure_bar = -0.0F;
  CHECK(plus == minus);
  minus.boom[3].rod_count = 9;
  CHECK(plus != minus);
}
