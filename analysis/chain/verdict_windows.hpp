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

/// Which of the windows of a recording, in the order of time, count as drilling: those of
/// kDrillingProbability, and from kStillDrilling on those that follow one another up to such a window.
/// Thread: OFF.
std::vector<bool> drilling_windows(const std::vector<VerdictWindow>& verdict);

}  // namespace rigsound::analysis
