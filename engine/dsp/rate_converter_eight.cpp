#include "rate_converter_rows.hpp"
#include "rigsound/dsp/lanes.hpp"

namespace rigsound::dsp {
namespace {

/// dot() with both its accumulators in one vector.
float dot_eight(const float* a, const float* b, int n) noexcept {
  using Eight = float __attribute__((vector_size(32)));
  const auto at = [](const float* p) {
    Eight v;
    std::memcpy(&v, p, sizeof v);
    return v;
  };
  Eight s{};
  for (int i = 0; i < n; i += 8) s += at(a + i) * at(b + i);
  return total(__builtin_shufflevector(s, s, 0, 1, 2, 3) + __builtin_shufflevector(s, s, 4, 5, 6, 7));
}

}  // namespace

void convert_rows_eight(const PhaseRows& rows, const float* x, float* out, std::size_t count) noexcept {
  convert_rows<dot_eight>(rows, x, out, count);
}

}  // namespace rigsound::dsp
