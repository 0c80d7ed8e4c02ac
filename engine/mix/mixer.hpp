// Layers in, channels out: gains, pan, equaliser, output level, limiter.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "mix/buses.hpp"
#include "mix/limiter.hpp"
#include "mix/lookahead_limiter.hpp"
#include "mix/output.hpp"
#include "rigsound/dsp/biquad.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/options.hpp"

namespace rigsound::mix {

class Mixer {
 public:
  explicit Mixer(const EngineOptions& options);  ///< Thread: OFF

  /// Mixes one chunk at the output level `gain`. To `out` (kChunk x channels, interleaved) goes the chunk
  /// that came the look-ahead earlier. Thread: RT.
  void process(const Buses& buses, const dsp::Ramp& gain, float* out) noexcept;

  double lowest_gain() const noexcept;  ///< of the limiter, over the last chunk
  /// Of the output over a block of so many samples; begins anew.
  LayerLevel take_level(int samples) noexcept { return output_.take(samples); }
  std::uint64_t take_dropped() noexcept { return std::exchange(dropped_, 0); }  ///< since the last call

 private:
  bool mix(const Buses& buses, const dsp::Ramp& gain, dsp::Lanes* x) noexcept;
  bool place(const Buses& buses, dsp::Lanes* x) const noexcept;
  bool equalise(bool sounds, dsp::Lanes* x) noexcept;

  int booms_;
  std::array<dsp::Lanes, kMaxBooms> drill_{}, tool_{};  ///< gains, left and right
  dsp::Lanes diesel_{};
  std::vector<dsp::BiquadPair> equaliser_;
  std::optional<LookaheadLimiter> ahead_;  ///< none: limiter_ limits x_
  Limiter limiter_;
  dsp::Lanes x_[kChunk] = {};
  Output output_;
  std::uint64_t dropped_ = 0;
};

}  // namespace rigsound::mix
