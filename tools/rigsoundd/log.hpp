// What the daemon says to whoever runs it. spdlog costs seconds in every file that includes it: log.cpp does.
#pragma once

#include <cstdint>
#include <string>

namespace rigsound::daemon {

/// To the journal when systemd runs us, else to stderr; written by a thread of its own, so that a slow
/// terminal holds nobody up. Thread: CT, once.
void start_log();
void stop_log();                   ///< writes the rest
std::uint64_t lost_log_entries();  ///< dropped because the log could not keep up

/// One entry each. Thread: CT
void log_info(const std::string& text);
void log_warning(const std::string& text);
void log_error(const std::string& text);

}  // namespace rigsound::daemon
