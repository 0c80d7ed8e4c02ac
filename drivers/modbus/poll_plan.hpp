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

/// For a request that a device refused as a whole: in its place requests without gaps, or, where it had none,
/// one a value. False, and nothing changed, when it is for one value already.
bool split(std::vector<PollRequest>& plan, const PollRequest& request,
           const std::vector<RegisterRoute>& routes);

}  // namespace rigsound::modbus
