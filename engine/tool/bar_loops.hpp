// One steel: both loops, the high-pass, and the gate that lets a silent bar sleep.
#pragma once

#include "rigsound/tool_model.hpp"
#include "tool/bar_kernel.hpp"
#include "tool/bar_state.hpp"

namespace rigsound::tool {

class BarLoops {
 public:
  /// A silent steel. `design` must have passed require_valid() or come from design_tool(). Thread: RT (no
  /// allocation).
  BarLoops(const ToolDesign& design, double highpass_hz, dsp::LaneWidth width) noexcept;

  /// drive.frames samples, mixed and high-passed, to `out`; exact zeros while asleep. Thread: RT.
  void process(const BarDrive& drive, double* out) noexcept;

  void reset() noexcept;  ///< to silence. Thread: RT

  bool asleep() const noexcept { return asleep_; }
  const BarState& state() const noexcept { return state_; }
  BarState& state() noexcept { return state_; }

 private:
  void seat(int stages_T, int stages_L, int width) noexcept;
  bool skew_fits(const LoopDesign& loop, Family family) const noexcept;
  void place_sequence(const ToolDesign& design) noexcept;
  void place_sections(const LoopDesign& loop, Family family, int width) noexcept;
  void place_paper_loops(const ToolDesign& design, dsp::LaneWidth width) noexcept;
  void place_filters(const LoopDesign& loop, Family family, double sign) noexcept;

  BarState state_{};
  BarKernel kernel_;
  bool asleep_ = true;
};

}  // namespace rigsound::tool
