// What writing files and folders has in common.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rigsound::file {

/// Throws the DeviceError `PATH: WHAT: the system's words for ERROR`. Thread: OFF, CT.
[[noreturn]] void fail(const std::filesystem::path& path, const char* what, int error);

/// Writes all of it, in as many turns as the system takes. Throws the DeviceError `WHAT: the system's words`.
/// Thread: OFF.
void write_all(int fd, const char* bytes, std::size_t size, const std::string& what);

/// Returns when the file's content is on the disk. Errors: DeviceError. Thread: OFF, CT.
void flush_to_disk(const std::filesystem::path& path);

/// The file or folder that a link leads to, there or not; anything else as it is. Thread: OFF, CT.
std::filesystem::path behind_links(const std::filesystem::path& target);

}  // namespace rigsound::file
