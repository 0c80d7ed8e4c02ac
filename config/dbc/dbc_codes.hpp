// Which raw values of a signal are none, as the texts of VAL_ say.
#pragma once

#include <vector>

#include "rigsound/config/dbc.hpp"

namespace rigsound::config {

/// A code for every raw value with a text: "error", "invalid", "not available", "SNA", ... mean that there is
/// no value; any other text makes the raw value one, also where J1939 sets it apart.
std::vector<can::RawCode> raw_codes(const DbcSignal& signal);

}  // namespace rigsound::config
