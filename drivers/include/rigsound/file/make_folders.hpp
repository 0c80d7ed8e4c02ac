// Folders that a signal does not bring back.
#pragma once

#include <filesystem>

namespace rigsound {

/// Makes a folder and its parents, unless they are there. Once undo_unfinished() has begun it waits for ever,
/// as all that is begun then does: what was removed does not come back. Errors: DeviceError. Thread: OFF, CT.
void make_folders(const std::filesystem::path& folder);

}  // namespace rigsound
