// Long recordings: cut into overlapping segments, analysed one by one, joined without a seam.
#pragma once

#include <vector>

#include "rigsound/analysis/chain.hpp"

namespace rigsound::analysis {

/// Samples [begin, end) of the recording; neighbours overlap.
struct Segment {
  long begin = 0, end = 0;
};

/// One segment up to 4 s, else segments of 2.3 to 3.5 s that overlap by kSegmentOverlap. Thread: OFF.
std::vector<Segment> plan_segments(long length);

constexpr long kSegmentOverlap = 24000;  ///< samples, half a second

/// The verdict on a recording from those on its segments (same order): it drills where a window of one does.
/// In an overlap both segments know the clicks: the left one's count
/// up to a click that both found, the right one's from there on, so none is lost or counted twice. Envelope:
/// the median over the segments with drilling. Thread: OFF.
SegmentedResult join_segments(const std::vector<Segment>& segments, std::vector<ChainResult> results);

/// The sound of the whole recording: crossfaded over the overlaps by linear ramps that sum to 1, because both
/// sides hold the same sound. Thread: OFF.
std::vector<float> join_drilling(const std::vector<Segment>& segments,
                                 const std::vector<ChainResult>& results);

/// For a labelled recording, whose results keep the clicks of refused segments: where no segment passes for
/// drilling, those with enough clicks do, their doubts kept; where one does, it alone. Thread: OFF.
void trust_the_label(std::vector<ChainResult>& results);

}  // namespace rigsound::analysis
