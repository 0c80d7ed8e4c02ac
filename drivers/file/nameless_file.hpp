// Temporary files that nobody can leave behind: they have no name.
#pragma once

#include <cstddef>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::file {

/// In the folder for temporary files. Errors: DeviceError. Thread: OFF.
FileDescriptor nameless_file();

/// Errors: DeviceError when there is no room. Thread: OFF.
void write_all(int fd, const char* bytes, std::size_t size);

}  // namespace rigsound::file
