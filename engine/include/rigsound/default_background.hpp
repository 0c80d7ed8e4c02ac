// A diesel from a formula, for rigs without a recording of their own.
#pragma once

#include <string_view>

#include "rigsound/background_model.hpp"

namespace rigsound {

/// The name default_background() goes by.
inline constexpr std::string_view kDefaultBackground = "built-in diesel";

/// A six-cylinder four-stroke diesel from a formula: firing pulses of slightly uneven cylinders, combustion
/// noise in bursts after each, a body of ten resonances, a nine-piston pump. About -30 dBFS rms at idle.
/// Thread: OFF.
BackgroundModel default_background();

}  // namespace rigsound
