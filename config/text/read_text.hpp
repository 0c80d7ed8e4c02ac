// A whole text file in memory.
#pragma once

#include <filesystem>
#include <string>

namespace rigsound::config {

/// Errors: InputError when the file is missing, unreadable or a folder.
std::string read_text(const std::filesystem::path& file);

}  // namespace rigsound::config
