// How deep a JSON text may go: parsers recurse, or keep, a level for each bracket.
#pragma once

#include <cstddef>
#include <string_view>

namespace rigsound::config {

constexpr int kMaxJsonDepth = 32;  ///< levels of brackets

/// Offset of the first bracket that opens a level below `depth`, npos when there is none. Thread: any.
std::size_t position_below(std::string_view text, int depth);

}  // namespace rigsound::config
