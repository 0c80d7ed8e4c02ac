// What of a rig is heard, without the buses that move it: enough for a library, and for a browser.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/config/sound_set_parts.hpp"
#include "rigsound/engine.hpp"

namespace rigsound::config {

struct SoundingRig {
  std::filesystem::path file;
  EngineOptions engine;                 ///< BoomOptions::tool is filled in by load_sounds
  std::filesystem::path sound_set;      ///< folder or packed file; empty when the rig names none
  int sound_set_line = 0;               ///< of the rig file, for messages
  std::vector<std::string> boom_tools;  ///< names, one a boom; empty: none that rings
  std::vector<int> boom_tool_lines;
};

/// The sounds of a set that is read, at the rig's rate; finds the tool of each boom in it. A set without a
/// background gets the built-in diesel: a rig whose engine runs is never silent. Errors: InputError. Thread:
/// OFF.
SoundSet sounds_of(SoundingRig& rig, SoundSetParts parts);

/// The rig that a set was packed with. `file` is for messages. Errors: InputError when it was packed without
/// one. Thread: OFF.
SoundingRig rig_of(const PackedSet& set, const std::filesystem::path& file);

/// The engine of the rig with its sounds. Errors: InputError naming the sound set when the engine cannot play
/// it. Thread: OFF.
Engine build_engine(const SoundingRig& rig, SoundSet sounds);

}  // namespace rigsound::config
