// The daemon's status as people read it.
#pragma once

#include <string>

#include "ctl/control_client.hpp"

namespace rigsound::tools {

/// Many lines, each at most 100 columns.
std::string status_text(const Json& status);

}  // namespace rigsound::tools
