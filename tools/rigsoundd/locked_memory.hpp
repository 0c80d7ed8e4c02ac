// Keeps the daemon's pages in memory.
#pragma once

#include <string>

namespace rigsound::daemon {

/// Locks what is there and what will come, as it is touched. Returns "locked", or why not. Thread: CT, before
/// other threads start.
std::string lock_memory();

}  // namespace rigsound::daemon
