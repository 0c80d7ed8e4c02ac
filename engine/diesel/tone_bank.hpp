// Sine oscillators: lines that the cycle does not hold, and the strokes of the pump.
#pragma once

#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/dsp/ramp.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::diesel {

class ToneBank {
 public:
  ToneBank(const std::vector<DieselOscillator>& tones, double sample_rate, std::uint64_t seed,
           std::uint64_t stream);  ///< Thread: OFF

  /// Adds kChunk samples to `out`; `f`: cycles a second at the chunk's middle. Thread: RT.
  void add(double f, const dsp::Ramp& gain, double* out) noexcept;

 private:
  struct Tone {
    DieselOscillator line;
    double phase = 0;  // cycles
  };
  std::vector<Tone> tones_;
  double sample_rate_;
  dsp::RandomField random_;
  std::uint64_t chunk_ = 0;
};

}  // namespace rigsound::diesel
