// Where in a recording the verdict is asked: windows of 2 s, one every second.
#pragma once

#include <vector>

#include "chain/segments.hpp"

namespace rigsound::analysis {

/// Windows of a recording of `length` samples, the last one up to its end; one of all of it up to 2 s.
/// Thread: OFF.
std::vector<Segment> plan_windows(long length);

/// For each segment the windows of which it holds more than any other, in samples of the segment; one may
/// reach beyond it. Thread: OFF.
std::vector<std::vector<Segment>> windows_by_segment(const std::vector<Segment>& windows,
                                                     const std::vector<Segment>& segments);

}  // namespace rigsound::analysis
