// A sound set in one file: to copy to a cabin, to embed in a program, to open without a folder.
//
// Little-endian. "RIGSET\x1a\n"; version (4 bytes); 4 zero bytes; size of the file (8); SHA-256 of all that
// follows (32); where the samples begin, counted from the file's start (8); the index and every model in the
// order of their lists of fields; then the samples of the clicks, float32, each click at a multiple of 64
// bytes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rigsound/config/sound_set_parts.hpp"
#include "rigsound/options.hpp"

namespace rigsound::config {

/// What a rig adds to its sound set, so that a packed one plays alone.
struct PackedRig {
  EngineOptions engine;                 ///< BoomOptions::tool not yet looked up
  std::vector<std::string> boom_tools;  ///< names, one a boom; empty: none that rings
};

struct PackedSet {
  SoundSetParts parts;
  std::optional<PackedRig> rig;
};

bool is_packed(std::string_view bytes);  ///< by its first bytes; Thread: any

/// The whole file. Thread: OFF.
std::string packed(const PackedSet& set);

/// The click whose samples are `bytes`.
using ClickOfBytes = std::function<Click(std::string_view bytes)>;
Click copied_click(std::string_view bytes);  ///< Thread: any

/// Checks hash, every length before it is used and every number; what is not as packed() writes it is
/// refused. `file` is for messages; `click_of` is given parts of `bytes`. Errors: InputError. Thread: OFF.
PackedSet read_packed(std::string_view bytes, const std::string& file,
                      const ClickOfBytes& click_of = copied_click);

/// The same of a file on disk: clicks stay where they were read to. Errors: InputError. Thread: OFF.
PackedSet load_packed(const std::filesystem::path& file);

}  // namespace rigsound::config
