// The numbers of a row as text: what fmt prints with {:.6f} and {:.10g}, at a fraction of its time where the
// number has few digits, as nearly all on a bus have.
#pragma once

#include <fmt/format.h>

namespace rigsound::tools {

/// Seconds with six decimals. Thread: any.
void append_seconds(fmt::memory_buffer& text, double seconds);

/// Ten digits at most. Thread: any.
void append_value(fmt::memory_buffer& text, double value);

}  // namespace rigsound::tools
