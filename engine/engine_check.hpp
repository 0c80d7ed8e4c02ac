// What an engine may be built from.
#pragma once

#include "rigsound/engine.hpp"

namespace rigsound {

/// Options that go together and sounds that can be played with them. Throws InvalidField. Thread: OFF.
void require_valid(const EngineOptions& options, const SoundSet& sounds);

}  // namespace rigsound
