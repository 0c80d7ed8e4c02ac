// The other programs of ours, which lie in the folder of this one. Thread: OFF.
#pragma once

#include <filesystem>
#include <string>

namespace rigsound::tools {

/// Errors: DeviceError when it is not there.
std::filesystem::path neighbour(const std::string& name);

/// Goes on as that program, with the words that this one was started with. Errors: DeviceError.
[[noreturn]] void become(const std::string& name);

}  // namespace rigsound::tools
