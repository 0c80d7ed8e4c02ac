// What a user may set while it plays: signals of the machine, which then stand by hand, and controls of the
// drill.
#pragma once

#include <stdexcept>

#include "commands.hpp"
#include "rigsound/config/json.hpp"

namespace rigsound::daemon {

/// A request that cannot be met; what() is for the user.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// {"key": [BOOM.]NAME, "value": NUMBER or WORD}: a signal or a control; without a boom one of the booms is
/// meant for all of them. A word is one of the signal's, or the name of a rock. Answers with "set": what now
/// stands where. Errors: Refused, and nothing is set. Thread: CT.
Json set_value(const Json& request, DaemonControl& daemon);

/// {"key": [BOOM.]NAME or "all"}: a signal goes back to its bus, a control to neutral. Answers with
/// "released": what was not so already. Errors: Refused. Thread: CT.
Json release_value(const Json& request, DaemonControl& daemon);

}  // namespace rigsound::daemon
