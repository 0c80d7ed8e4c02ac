// Counter-based random numbers: a value is a function of (seed, index, field), never of what ran before.
#pragma once

#include <cstdint>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::dsp {

/// The finaliser of SplitMix64 (Steele, Lea, Flood 2014): neighbouring inputs give unrelated outputs.
/// Thread: RT.
constexpr std::uint64_t mix64(std::uint64_t z) noexcept {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// One independent stream of random numbers. Plain value, no hidden state. Thread: RT.
class RandomField {
 public:
  /// Streams with different (seed, layer, boom) are independent.
  constexpr RandomField(std::uint64_t seed, std::uint64_t layer, std::uint64_t boom = 0) noexcept
      : key_(mix64(mix64(seed + 0x9e3779b97f4a7c15ULL) + mix64((layer << 32) + boom + 1))) {}

  constexpr std::uint64_t bits(std::uint64_t index, std::uint64_t field) const noexcept {
    return mix64(key_ + 0x9e3779b97f4a7c15ULL * (index * 64 + field + 1));
  }

  /// Uniform in [0, 1). `field` < 64 tells apart the draws made for one index.
  constexpr double uniform(std::uint64_t index, std::uint64_t field) const noexcept {
    // 53 bits fit a signed number, which every processor converts in one step.
    return static_cast<double>(static_cast<std::int64_t>(bits(index, field) >> 11)) * 0x1p-53;
  }

  /// White noise of zero mean and unit variance, uniform: cheaper than normal() where the ear cannot tell.
  constexpr double white(std::uint64_t index, std::uint64_t field) const noexcept {
    return 3.46410161513775 * (uniform(index, field) - 0.5);  // sqrt 12
  }

  /// Standard normal (Box-Muller, cosine branch); uses `field` and `field + 1`.
  double normal(std::uint64_t index, std::uint64_t field) const noexcept {
    const double radius = std::sqrt(-2 * log(1 - uniform(index, field)));
    return radius * cos(kTwoPi * uniform(index, field + 1));
  }

 private:
  std::uint64_t key_;
};

}  // namespace rigsound::dsp
