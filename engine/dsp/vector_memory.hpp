// Vectors from and to memory, for files compiled once per vector width: internal linkage, because the linker
// must not merge code compiled for different processors.
#pragma once

#include <cstring>

namespace rigsound::dsp {
namespace {

template <class V, class T>
V vector_at(const T* from) noexcept {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class V, class T>
void put(T* to, V v) noexcept {
  std::memcpy(to, &v, sizeof v);
}

}  // namespace
}  // namespace rigsound::dsp
