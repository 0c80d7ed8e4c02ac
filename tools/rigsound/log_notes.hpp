// What verbs that read a bus log say about it.
#pragma once

#include <string>

#include "rigsound/log/bus_log.hpp"

namespace rigsound::tools {

/// What there is to know of a log read to its end, to stderr.
void print_log_notes(const std::string& file, const log::BusLog& log);

}  // namespace rigsound::tools
