// How many numbers this processor computes side by side.
#pragma once

namespace rigsound::dsp {

/// Doubles in one vector. kTwo is SSE2 or NEON, kFour AVX2.
enum class LaneWidth : int { kTwo = 2, kFour = 4 };

/// The widest this processor has. Thread: any.
inline LaneWidth widest_lanes() noexcept {
#ifdef RIGSOUND_AVX2
  if (__builtin_cpu_supports("avx2")) return LaneWidth::kFour;
#endif
  return LaneWidth::kTwo;
}

/// What `take` returns for the Kernels of the widest lanes. Those of each width are compiled in a file of
/// their own.
template <template <LaneWidth> class Kernels, class Take>
auto with_widest(Take take) noexcept {
#ifdef RIGSOUND_AVX2
  if (widest_lanes() == LaneWidth::kFour) return take(Kernels<LaneWidth::kFour>());
#endif
  return take(Kernels<LaneWidth::kTwo>());
}

}  // namespace rigsound::dsp
