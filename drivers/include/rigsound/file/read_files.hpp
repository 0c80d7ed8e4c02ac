// Keeps what is read from being written over.
#pragma once

#include <filesystem>
#include <vector>

namespace rigsound {

/// Errors: InputError when writing one of `outputs` would replace one of `inputs`, by whatever name or link,
/// a file that lies in an input that is a folder, or another of `outputs`. Empty paths count for nothing, as
/// do devices, pipes and `-`. Thread: OFF.
void require_apart(const std::vector<std::filesystem::path>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

/// Errors: InputError when one of `inputs` lies in `folder`, whose content is made anew. Thread: OFF.
void require_outside(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& inputs);

}  // namespace rigsound
