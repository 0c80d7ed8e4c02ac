// Where the daemon's words go.
#pragma once

#include <cstdint>

namespace rigsound::daemon {

/// To the journal when systemd runs us, else to stderr; written by a thread of its own, so that a slow
/// terminal holds nobody up. Thread: CT, once.
void start_log();
void stop_log();                   ///< writes the rest
std::uint64_t lost_log_entries();  ///< dropped because the log could not keep up

}  // namespace rigsound::daemon
