// Bytes of captures, written as their specifications draw them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rigsound::test {

using Octets = std::vector<std::uint8_t>;

/// `value` in so many octets, in network order or the other way round.
inline Octets octets(std::uint64_t value, int count, bool big_endian = true) {
  Octets out;
  for (int i = 0; i < count; ++i)
    out.push_back(static_cast<std::uint8_t>(value >> 8 * (big_endian ? count - 1 - i : i)));
  return out;
}

inline Octets operator+(Octets a, const Octets& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

inline std::string text_of(const Octets& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace rigsound::test
