// States that differ from a given one in a single field.
#pragma once

#include <type_traits>
#include <vector>

#include "rigsound/machine/machine_state.hpp"

namespace rigsound::tests {

/// One for each field of a state, in order.
inline std::vector<MachineState> with_one_field_other(const MachineState& state) {
  int fields = 0;
  for_each_field(state, [&](const auto&) { ++fields; });
  std::vector<MachineState> others(static_cast<std::size_t>(fields), state);
  for (int changed = 0; changed < fields; ++changed) {
    int i = 0;
    for_each_field(others[static_cast<std::size_t>(changed)], [&](auto& field) {
      using Field = std::decay_t<decltype(field)>;
      if (i++ == changed) field = static_cast<Field>(static_cast<double>(field) == 1 ? 0 : 1);
    });
  }
  return others;
}

}  // namespace rigsound::tests
