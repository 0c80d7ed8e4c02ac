// A short name for everything that decides what a rig sounds like.
#pragma once

#include <string>

#include "rigsound/config/rig.hpp"

namespace rigsound::config {

/// 16 hexadecimal digits over the engine's options (the seed apart, which may be chosen per run) and every
/// byte of the sound set. Equal inputs give equal names; not meant to withstand malice. Errors: InputError
/// when a file cannot be read. Thread: OFF.
std::string fingerprint(const Rig& rig);

}  // namespace rigsound::config
