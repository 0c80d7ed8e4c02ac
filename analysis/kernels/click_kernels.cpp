#include "kernels/click_kernels.hpp"

#include "kernels/instruction_set.hpp"

namespace rigsound::analysis {

extern const ClickKernels kClickKernels_baseline;
#ifdef RIGSOUND_X86_KERNELS
extern const ClickKernels kClickKernels_avx2, kClickKernels_avx512;
#endif

const ClickKernels& click_kernels() {
#ifdef RIGSOUND_X86_KERNELS
  if (instruction_set() == InstructionSet::kAvx512) return kClickKernels_avx512;
  if (instruction_set() == InstructionSet::kAvx2) return kClickKernels_avx2;
#endif
  return kClickKernels_baseline;
}

}  // namespace rigsound::analysis
