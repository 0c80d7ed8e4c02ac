#include "tool/bar_kernel_four.hpp"

#define RIGSOUND_LANES 4
#include "tool/bar_kernel_lanes.hpp"

namespace rigsound::tool {

BarKernel section_kernel_four(int vectors_T) noexcept { return with_transversal<1>(vectors_T); }

BarKernel paper_kernel_four() noexcept { return run_paper; }

}  // namespace rigsound::tool
