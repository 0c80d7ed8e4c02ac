// Layers in, channels out: gains, pan, equaliser, limiter.
#pragma once

#include <array>
#include <vector>

#include "mix/buses.hpp"
#include "mix/limiter.hpp"
#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/options.hpp"

namespace rigsound::mix {

class Mixer {
 public:
  explicit Mixer(const EngineOptions& options);  ///< Thread: OFF

  /// Mixes one chunk to `out` (kChunk x channels, interleaved) at the output level `gain`. Thread: RT.
  void process(const Buses& buses, const dsp::Ramp& gain, float* out) noexcept;

  double lowest_gain() const noexcept { return limiter_.lowest_gain(); }

 private:
  void place(const Buses& buses, double (*x)[kChunk]) const noexcept;

  int booms_, channels_;
  float ceiling_;
  struct BoomGains {
    std::array<double, kMaxChannels> drill{}, tool{};
  };
  std::array<BoomGains, kMaxBooms> boom_{};
  std::array<double, kMaxChannels> diesel_{};
  std::vector<dsp::Biquad> equaliser_;  ///< bands of channel 0, then of channel 1, ...
  int bands_;
  Limiter limiter_;
};

}  // namespace rigsound::mix
