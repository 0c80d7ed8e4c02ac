// What verbs that read a bus log say about it.
#pragma once

#include <string>

#include "rigsound/config/rig.hpp"
#include "rigsound/log/can_log.hpp"

namespace rigsound::tools {

/// Errors: InputError when the rig has no CAN bus that a log could be of.
void require_can(const config::Rig& rig);

/// Counts of a log read to its end, to stderr.
void print_log_notes(const std::string& file, const log::CanLog& log);

}  // namespace rigsound::tools
