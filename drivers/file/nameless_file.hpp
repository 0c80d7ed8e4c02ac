// Temporary files that nobody can leave behind: they have no name.
#pragma once

#include <cstddef>

#include "rigsound/file/file_descriptor.hpp"

namespace rigsound::file {

/// In the folder for temporary files. Errors: DeviceError. Thread: OFF.
FileDescriptor nameless_file();

/// More of the input that is kept there. Errors: DeviceError when there is no room. Thread: OFF.
void add_to(const FileDescriptor& nameless, const char* bytes, std::size_t size);

}  // namespace rigsound::file
