// Keeps what is read from being written over.
#pragma once

#include <filesystem>
#include <vector>

namespace rigsound {

/// Errors: InputError when writing `output` would replace one of `inputs`, by whatever name or link, or a
/// file that lies in an input that is a folder. Empty paths count for nothing. Thread: OFF.
void require_not_read(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs);

}  // namespace rigsound
