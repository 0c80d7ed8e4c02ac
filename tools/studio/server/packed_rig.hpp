// What engine.wasm plays: the sound set packed with a rig.
#pragma once

#include <string>

#include "rigsound/config/packed_set.hpp"
#include "rigsound/machine/signal.hpp"
#include "workplace.hpp"

namespace rigsound::studio {

/// The engine options of --rig, else the usual ones. Errors: InputError. Thread: any.
EngineOptions engine_of(const Workplace& place);

/// The options of --rig, else of a rig of one boom with the first bar of the set. Errors: InputError. Thread:
/// any.
config::PackedRig rig_of(const Workplace& place, const config::SoundSetParts& parts);

/// The packed set; `with_rig`: and the rig, once the engine was built with it. Errors: InputError.
enum class PackRig { kLeftOut, kEmbedded };
std::string packed_sound_set(const Workplace& place, PackRig rig);

/// Of the values 0, 1, ... of a signal; null where it has none. Thread: any.
Json words_of(const SignalInfo& signal);

/// GET /rig.
Json rig_description(const Workplace& place);

}  // namespace rigsound::studio
