// A whole text file in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace rigsound::config {

/// A kind of text file, and how large one may be.
struct TextKind {
  const char* name;
  std::size_t most_bytes;
};
constexpr TextKind kRigText{"rig", 1 << 20}, kDbcText{"DBC file", 16 << 20},
    kIndexText{"soundset.toml", 1 << 20}, kModelText{"model", 16 << 20};

/// Errors: InputError when the file is missing, unreadable, a folder or larger than its kind may be.
std::string read_text(const std::filesystem::path& file, const TextKind& kind);

}  // namespace rigsound::config
