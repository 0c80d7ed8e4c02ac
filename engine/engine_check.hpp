// What an engine may be built from.
#pragma once

#include "rigsound/engine.hpp"

namespace rigsound {

/// Throws std::invalid_argument that names the option, its value's limits and the mend. Thread: OFF.
void require_valid(const EngineOptions& options, const SoundSet& sounds);

}  // namespace rigsound
