#include "kernels/instruction_set.hpp"

namespace rigsound::analysis {
namespace {

InstructionSet ask_processor() {
#ifdef RIGSOUND_X86_KERNELS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
    return InstructionSet::kAvx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::kAvx2;
#endif
  return InstructionSet::kBaseline;
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet best = ask_processor();
  return best;
}

}  // namespace rigsound::analysis
