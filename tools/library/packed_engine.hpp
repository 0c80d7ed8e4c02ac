// The engine of a sound set that was packed with its rig.
#pragma once

#include <filesystem>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::library {

/// `file` is for messages. Errors: InputError. Thread: OFF.
Engine engine_of(config::PackedSet set, const std::filesystem::path& file);

}  // namespace rigsound::library
