#include "tool/bar_kernel_four.hpp"

#define RIGSOUND_LANES 4
#include "tool/bar_kernel_lanes.hpp"

namespace rigsound::tool {

BarKernel section_kernel_four(const Seats (&seats)[2]) noexcept {
  const int vectors_T = seats[kTransversal].vectors;
  return seats[kLongitudinal].base == 0 ? sections_with<0>(vectors_T, SharedCounts{})
                                        : sections_with<1>(vectors_T, SectionCounts{});
}

BarKernel paper_kernel_four(int vectors) noexcept { return paper_with(vectors, PaperCounts{}); }

}  // namespace rigsound::tool
