// Vectors of RIGSOUND_LANES doubles. Included by one source file per width; everything has internal linkage,
// because the linker must not merge code compiled for different processors.
#pragma once

#include <cstring>

#include "string/string_kernel.hpp"

namespace rigsound::string {
namespace {

constexpr int W = RIGSOUND_LANES;
constexpr int kParts = kGroup / W;  // vectors that hold a group
using V __attribute__((vector_size(W * sizeof(double)))) = double;
using Bits __attribute__((vector_size(W * sizeof(double)))) = std::int64_t;

inline V load(const double* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// The same from an address that is a multiple of the vector's size; SSE2 then loads where it computes.
inline V load_aligned(const double* from) {
  V v;
  std::memcpy(&v, __builtin_assume_aligned(from, sizeof v), sizeof v);
  return v;
}

inline void store(double* to, V v) { std::memcpy(to, &v, sizeof v); }

inline V everywhere(double x) { return V{} + x; }

}  // namespace
}  // namespace rigsound::string
