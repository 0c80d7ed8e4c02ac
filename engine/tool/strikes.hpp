// What hits the bar: a Hann pulse for every blow and for each of its bounces (jackhammer paper, section 3.3).
#pragma once

#include <array>

#include "dsp/random.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

/// kChunk samples of excitation.
struct Excitation {
  double x[kChunk];
  double slope[kChunk];  ///< > 0 where a pulse begins: factor on the contact's ramps; else 0
};

/// Blows in, pulses out. A pulse begins where its blow does, between samples if need be, so that a blow
/// sounds the same at every sample rate. Thread: RT.
class Strikes {
 public:
  Strikes(const Strike& strike, double sample_rate, std::uint64_t seed, int boom) noexcept;

  /// The chunk's blows, on average `period` samples apart, and what is left of earlier ones.
  void process(const Impact* impacts, int count, double period, Excitation& out) noexcept;

 private:
  struct Pulse {
    double onset = 0;  ///< samples after the chunk's first; negative once it has begun
    double amplitude = 0, slope = 1;
  };

  void add(const Impact& impact, double period) noexcept;
  void push(const Pulse& pulse) noexcept;
  void render(const Pulse& pulse, Excitation& out) const noexcept;

  static constexpr int kMaxPulses = 96;  ///< of blows a whole chunk full, with every bounce

  Strike strike_;
  double width_;  ///< samples
  dsp::RandomField random_;
  std::array<Pulse, kMaxPulses> pulses_{};
  int count_ = 0;
};

}  // namespace rigsound::tool
