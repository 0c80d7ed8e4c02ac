// A diesel from a formula, for rigs without a recording of their own.
#pragma once

#include <string_view>

#include "rigsound/diesel_model.hpp"

namespace rigsound {

/// The name default_diesel() goes by.
inline constexpr std::string_view kDefaultDiesel = "built-in diesel";

/// A six-cylinder four-stroke diesel from a formula: firing pulses of slightly uneven cylinders, combustion
/// noise in bursts after each, a body of ten resonances, a nine-piston pump. About -30 dBFS rms at idle.
/// Thread: OFF.
DieselModel default_diesel();

}  // namespace rigsound
