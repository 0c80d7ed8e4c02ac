// The four-lane kernel, compiled for AVX2 in a file of its own. Use only when widest_lanes() is kFour.
#pragma once

#include "string/string_kernel.hpp"

namespace rigsound::string {

const StringKernel& string_kernel_four() noexcept;

}  // namespace rigsound::string
