// A line with more points than columns of pixels, reduced to what can be seen of it.
#pragma once

#include "chart/canvas.hpp"

namespace rigsound::chart {

/// Lowest and highest point of every column of one pixel, in the order of the line,
/// rounded outwards to whole pixels; a line that goes to and
/// fro or has no more than one point a column stays as it is. Thread: OFF.
Run reduced(const Run& line);

}  // namespace rigsound::chart
