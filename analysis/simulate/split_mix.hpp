// The simulator's source of chance: a SplitMix64 stream with the draws the recordings are made of.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "rigsound/dsp/random.hpp"

namespace rigsound::analysis {

/// Sequential stream. Unlike dsp::RandomField its values depend on how many were drawn before, which
/// is what fixes a benchmark clip to its id. Thread: OFF.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() { return dsp::mix64(state_ += 0x9e3779b97f4a7c15ULL); }

  /// In [0, 1): the top 53 bits.
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }

  /// Standard normal: cosine branch of Box-Muller, two draws.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(dsp::kTwoPi * uniform());
  }

  std::vector<double> uniforms(std::size_t count) {
    std::vector<double> values(count);
    for (double& v : values) v = uniform();
    return values;
  }
  std::vector<double> normals(std::size_t count) {
    std::vector<double> values(count);
    for (double& v : values) v = normal();
    return values;
  }

 private:
  std::uint64_t state_;
};

}  // namespace rigsound::analysis
