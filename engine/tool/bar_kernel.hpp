// The inner loop of the ringing bar, once per vector width. All widths compute the same bits: lanes never
// mix, and what a lane does is written down in bar_state.hpp.
#pragma once

#include "rigsound/dsp/lane_width.hpp"
#include "tool/bar_state.hpp"

namespace rigsound::tool {

/// One chunk: drive.frames samples to `out`, mixed and high-passed. Thread: RT.
using BarKernel = void (*)(BarState& state, const BarDrive& drive, double* out) noexcept;

/// The kernel for families that sit there; they must fit kLanes. Thread: RT.
BarKernel section_kernel(const Seats (&seats)[2], dsp::LaneWidth width) noexcept;

/// The kernel for that many vectors of the paper's identical sections, within kPaperLanes. Thread: RT.
BarKernel paper_kernel(int vectors, dsp::LaneWidth width) noexcept;

/// Where a delay line is shorter than the skew: one section after another, in the lanes from the base of
/// their seats up; these count sections. Thread: RT.
void run_sections_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept;
void run_paper_in_sequence(BarState& state, const BarDrive& drive, double* out) noexcept;

}  // namespace rigsound::tool
