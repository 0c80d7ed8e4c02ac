// Keeps the daemon's pages in memory.
#pragma once

#include <string>

namespace rigsound::daemon {

/// Brings in and locks what is there, code included, and what will come. Returns "locked", or why not.
/// Thread: CT, before other threads start.
std::string lock_memory();

}  // namespace rigsound::daemon
