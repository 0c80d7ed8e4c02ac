// Sine oscillators: lines that the cycle does not hold, and the strokes of the pump.
#pragma once

#include <vector>

#include "dsp/random.hpp"
#include "rigsound/background_model.hpp"

namespace rigsound::background {

class ToneBank {
 public:
  ToneBank(const std::vector<BackgroundOscillator>& tones, double sample_rate, std::uint64_t seed,
           std::uint64_t stream);  ///< Thread: OFF

  /// Adds kChunk samples to `out`; the gain goes linearly over them. `f`: cycles a second at the chunk's
  /// middle. Thread: RT.
  void add(double f, double gain_from, double gain_to, double* out) noexcept;

 private:
  struct Tone {
    BackgroundOscillator line;
    double phase = 0;  // cycles
  };
  std::vector<Tone> tones_;
  double sample_rate_;
  dsp::RandomField random_;
  std::uint64_t chunk_ = 0;
};

}  // namespace rigsound::background
