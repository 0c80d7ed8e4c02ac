// What writing a file or a folder atomically has in common.
#pragma once

#include <filesystem>

namespace rigsound::file {

/// Throws the DeviceError `PATH: WHAT: the system's words for ERROR`. Thread: OFF, CT.
[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int error);

/// Returns when the file's content is on the disk. Errors: DeviceError. Thread: OFF, CT.
void flush_to_disk(const std::filesystem::path& path);

/// The file or folder that a link leads to, there or not; anything else as it is. Thread: OFF, CT.
std::filesystem::path behind_links(const std::filesystem::path& target);

}  // namespace rigsound::file
