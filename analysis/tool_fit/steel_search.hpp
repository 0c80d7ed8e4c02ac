// Which steel has these partials?
#pragma once

#include <optional>
#include <vector>

#include "rigsound/tool_model.hpp"
#include "tool_fit/partials.hpp"

namespace rigsound::analysis {

struct FoundSteel {
  Bar bar;
  int matched = 0;  ///< partials that lie on a mode of it
};

/// Length and diameter (whichever of `given` is 0) under which most partials are modes of a free bar; none
/// when fewer than four are, or when partials of anything would match some size as well once in a hundred
/// times. Thread: OFF.
std::optional<FoundSteel> find_steel(const std::vector<Partial>& partials, const Bar& given,
                                     double highest_hz);

}  // namespace rigsound::analysis
