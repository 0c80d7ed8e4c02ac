#include "string/string_kernel_four.hpp"

#define RIGSOUND_LANES 4
#include "string/string_kernel_lanes.hpp"

namespace rigsound::string {

const StringKernel& string_kernel_four() noexcept { return kKernel; }

}  // namespace rigsound::string
