#include "string/string_kernel.hpp"

#define RIGSOUND_LANES 2
#include "string/string_kernel_lanes.hpp"

#ifdef RIGSOUND_AVX2
#include "string/string_kernel_four.hpp"
#endif

namespace rigsound::string {

const StringKernel& string_kernel([[maybe_unused]] dsp::LaneWidth width) noexcept {
#ifdef RIGSOUND_AVX2
  if (width == dsp::LaneWidth::kFour) return string_kernel_four();
#endif
  return kKernel;
}

}  // namespace rigsound::string
