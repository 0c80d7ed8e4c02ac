#include "rigsound/machine/machine_state.hpp"

#include <array>

namespace rigsound {

bool operator==(const MachineState& a, const MachineState& b) noexcept {
  constexpr int kMostFields = 256;
  std::array<double, kMostFields> fields{};
  int count = 0, other = 0;
  bool equal = true;
  for_each_field(a, [&](const auto& field) { fields[count++] = static_cast<double>(field); });
  for_each_field(b,
                 [&](const auto& field) { equal = equal && fields[other++] == static_cast<double>(field); });
  return equal;
}

}  // namespace rigsound
