// Which requests read every register of a rig.
#pragma once

#include <vector>

#include "rigsound/modbus/modbus_options.hpp"

namespace rigsound::modbus {

struct PollRequest {
  Table table = Table::kHolding;
  std::uint16_t address = 0;
  int count = 0;  ///< registers or bits, at most 125
};

/// Near values (gaps of at most 8) share a request.
std::vector<PollRequest> poll_plan(const std::vector<RegisterRoute>& routes);

}  // namespace rigsound::modbus
