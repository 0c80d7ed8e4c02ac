#include "kernels/kl_kernels.hpp"

#include "kernels/instruction_set.hpp"

namespace rigsound::analysis {

extern const KlKernels kKlKernels_baseline;
#ifdef RIGSOUND_X86_KERNELS
extern const KlKernels kKlKernels_avx2, kKlKernels_avx512;
#endif

const KlKernels& kl_kernels() {
#ifdef RIGSOUND_X86_KERNELS
  if (instruction_set() == InstructionSet::kAvx512) return kKlKernels_avx512;
  if (instruction_set() == InstructionSet::kAvx2) return kKlKernels_avx2;
#endif
  return kKlKernels_baseline;
}

}  // namespace rigsound::analysis
