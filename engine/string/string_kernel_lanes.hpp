// The kernel for the lane width RIGSOUND_LANES.
#pragma once

#include "string/lines_lanes.hpp"
#include "string/modes_lanes.hpp"

namespace rigsound::string {
namespace {

void voice(VoiceState& s, const double* bending, double* sound) noexcept {
  alignas(32) double rise[kChunk + W];  // from sample to sample, W places late
  const V mix = everywhere(s.string_mix), b = everywhere(s.hp_b);
  double y = s.hp_y;
  rise[W - 1] = s.hp_x;
#pragma GCC unroll 4
  for (int n = 0; n < kChunk; n += W) store(rise + W + n, mix * load(sound + n) + load(bending + n));
  s.hp_x = rise[W + kChunk - 1];
#pragma GCC unroll 4
  for (int n = 0; n < kChunk; n += W) store(sound + n, b * (load(rise + W + n) - load(rise + W + n - 1)));
#pragma GCC unroll 8
  for (int n = 0; n < kChunk; ++n) sound[n] = y = sound[n] + s.hp_p * y;
  s.hp_y = y;
}

constexpr StringKernel kKernel = {lines, modes, tune, voice};

}  // namespace
}  // namespace rigsound::string
