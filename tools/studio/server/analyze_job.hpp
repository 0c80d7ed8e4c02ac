// The chain of a recording's parts as a process of its own: one that crashes or is killed takes nothing with
// it.
#pragma once

#include "workplace.hpp"

namespace rigsound::studio {

/// `body`: of POST /jobs. Errors: ApiError for a recording or a part that is not there.
Jobs::Work analyze_work(Workplace& place, const Json& body);

}  // namespace rigsound::studio
