// A snapshot as `ctl status --json` prints it.
#pragma once

#include <nlohmann/json.hpp>

#include "snapshot.hpp"

namespace rigsound::daemon {

nlohmann::ordered_json status_json(const Snapshot& snapshot);

}  // namespace rigsound::daemon
