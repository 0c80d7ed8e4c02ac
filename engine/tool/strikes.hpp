// What hits the bar: a Hann pulse for every blow and for each of its bounces (jackhammer paper, section 3.3).
#pragma once

#include <array>

#include "rigsound/dsp/random.hpp"
#include "rigsound/impact.hpp"
#include "rigsound/machine/limits.hpp"
#include "rigsound/tool_model.hpp"

namespace rigsound::tool {

/// A pulse's first sample: the hammer touches the steel.
struct Touch {
  int at;        ///< sample of the chunk
  double slope;  ///< factor on the contact's ramps
};

/// Blows in, pulses out. A pulse begins where its blow does, between samples if need be, so that a blow
/// sounds the same at every sample rate. Thread: RT.
class Strikes {
 public:
  Strikes(const Strike& strike, double sample_rate, std::uint64_t seed, int boom) noexcept;

  /// The chunk's blows, on average `period` samples apart, and what is left of earlier ones. Writes kChunk
  /// samples; false: all of them are zero.
  bool process(const Impacts& impacts, double period, double* x) noexcept;

  void reset() noexcept { count_ = touch_count_ = 0; }
  bool rests() const noexcept { return count_ == 0; }  ///< no pulse is under way

  /// Of the last chunk, in rising order.
  const Touch* begin() const noexcept { return touches_.data(); }
  const Touch* end() const noexcept { return touches_.data() + touch_count_; }

 private:
  struct Pulse {
    double onset = 0;  ///< samples after the chunk's first; negative once it has begun
    double amplitude = 0, slope = 1;
  };

  void add(const Impact& impact, double period) noexcept;
  void push(const Pulse& pulse) noexcept;
  void render(const Pulse& pulse, double* x) noexcept;
  void touch(int at, double slope) noexcept;

  static constexpr int kMaxPulses = 96;  ///< of blows a whole chunk full, with every bounce

  Strike strike_;
  double width_;                  ///< samples
  double step_, twice_cos_step_;  ///< of the pulse's cosine, rad/sample
  dsp::RandomField random_;
  std::array<Pulse, kMaxPulses> pulses_{};
  int count_ = 0;
  std::array<Touch, kChunk> touches_{};
  int touch_count_ = 0;
};

}  // namespace rigsound::tool
