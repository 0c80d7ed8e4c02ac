// The style sheet of charts and of the pages that hold them: light, dark and printed.
#pragma once

#include <string>

namespace rigsound::chart {

/// The roles as variables of a page, `var(--ink)` and so on. Thread: OFF.
std::string page_colours();

/// Classes of SVG marks: `sROLE` strokes and `fROLE` fills in the colour of a role. Written without
/// variables, which viewers of single SVG files do not know. Thread: OFF.
std::string chart_styles();

}  // namespace rigsound::chart
