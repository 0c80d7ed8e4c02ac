// What a log said of itself when it was read, for people.
#pragma once

#include <string>

#include "rigsound/log/bus_log.hpp"

namespace rigsound::tools {

/// One line a note on stderr: `FILE: text` or `FILE:LINE: text`.
void print_log_notes(const std::string& file, const log::BusLog& log);

}  // namespace rigsound::tools
