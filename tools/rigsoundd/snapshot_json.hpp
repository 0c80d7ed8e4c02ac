// A snapshot as `ctl status --json` prints it.
#pragma once

#include "rigsound/config/json.hpp"
#include "snapshot.hpp"

namespace rigsound::daemon {

Json status_json(const Snapshot& snapshot);

}  // namespace rigsound::daemon
