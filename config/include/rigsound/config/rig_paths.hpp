// The paths of a rig that only a daemon uses, looked at before it opens anything.
#pragma once

#include "rigsound/config/rig.hpp"

namespace rigsound::config {

/// `[control] socket` must be a socket or nothing yet, `token_file` hold a token. Opens nothing but that.
/// Errors: InputError. Thread: OFF.
void check_paths(const Rig& rig);

}  // namespace rigsound::config
