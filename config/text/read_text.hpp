// A whole text file in memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "rigsound/machine/fields.hpp"

namespace rigsound::config {

/// A kind of text file, and how large one may be.
struct TextKind {
  const char* name;
  std::size_t most_bytes;
};
constexpr TextKind kRigText{"rig", 1 << 20}, kDbcText{"DBC file", 16 << 20},
    kIndexText{"soundset.toml", 1 << 20}, kModelText{"model", 16 << 20};

constexpr Range kFormatNumbers{0, 1 << 20};  ///< of the key `format`; which of them is known says its reader

/// Errors: InputError when the file is missing, unreadable, a folder or larger than its kind may be.
std::string read_text(const std::filesystem::path& file, const TextKind& kind);

}  // namespace rigsound::config
