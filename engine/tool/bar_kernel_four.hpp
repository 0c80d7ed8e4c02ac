// The four-lane kernels, compiled for AVX2 in a file of their own. Call only when widest_lanes() is kFour.
#pragma once

#include "tool/bar_kernel.hpp"

namespace rigsound::tool {

BarKernel section_kernel_four(const Seats (&seats)[2]) noexcept;
BarKernel paper_kernel_four(int vectors) noexcept;

}  // namespace rigsound::tool
