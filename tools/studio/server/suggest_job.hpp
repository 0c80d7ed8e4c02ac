// Where a recording changes its situation, as a person would mark it.
#pragma once

#include "workplace.hpp"

namespace rigsound::studio {

/// `body`: of POST /jobs. Errors: ApiError for a recording that is not there.
Jobs::Work suggest_work(Workplace& place, const Json& body);

}  // namespace rigsound::studio
