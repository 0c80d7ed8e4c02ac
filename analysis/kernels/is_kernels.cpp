#include "kernels/is_kernels.hpp"

#include "kernels/instruction_set.hpp"

namespace rigsound::analysis {

extern const IsKernels kIsKernels_baseline;
#ifdef RIGSOUND_X86_KERNELS
extern const IsKernels kIsKernels_avx2, kIsKernels_avx512;
#endif

const IsKernels& is_kernels() {
#ifdef RIGSOUND_X86_KERNELS
  if (instruction_set() == InstructionSet::kAvx512) return kIsKernels_avx512;
  if (instruction_set() == InstructionSet::kAvx2) return kIsKernels_avx2;
#endif
  return kIsKernels_baseline;
}

}  // namespace rigsound::analysis
