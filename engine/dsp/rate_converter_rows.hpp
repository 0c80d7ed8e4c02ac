// The inner loop of RateConverter, once per vector width: all compute the bits of dot().
#pragma once

#include <cstddef>
#include <cstdint>

namespace rigsound::dsp {

/// `up` rows of `taps` weights, one a phase: `up` samples come of `down`.
struct PhaseRows {
  const float* weights;
  std::int64_t up, down;
  int taps;
};

/// `count` samples into `out`, each the product of its phase's row and what `x` holds from its place on.
/// Thread: OFF.
template <float (*product)(const float* a, const float* b, int n) noexcept>
void convert_rows(const PhaseRows& rows, const float* x, float* out, std::size_t count) noexcept {
  std::int64_t at = 0, phase = 0;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = product(rows.weights + phase * rows.taps, x + at, rows.taps);
    phase += rows.down;
    while (phase >= rows.up) phase -= rows.up, ++at;
  }
}

/// With eight floats side by side. Only on a processor that has AVX2.
void convert_rows_eight(const PhaseRows& rows, const float* x, float* out, std::size_t count) noexcept;

}  // namespace rigsound::dsp
