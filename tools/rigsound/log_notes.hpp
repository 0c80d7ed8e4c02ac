// What a log said of itself when it was read, for people.
#pragma once

#include <string>

#include "rigsound/config/rig.hpp"
#include "rigsound/log/bus_log.hpp"

namespace rigsound::tools {

/// One line a note on stderr: `FILE: text` or `FILE:LINE: text`; also one for each signal whose readings were
/// no value, or out of range.
void print_log_notes(const std::string& file, const log::BusLog& log, const config::Rig& rig);

}  // namespace rigsound::tools
