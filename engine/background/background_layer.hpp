// The diesel and its hydraulics.
#pragma once

#include <cstdint>
#include <vector>

#include "background/background_controls.hpp"
#include "dsp/random.hpp"
#include "rigsound/background_model.hpp"
#include "rigsound/limits.hpp"

namespace rigsound::background {

/// Harmonic-plus-noise engine in the crank-angle domain.
class BackgroundLayer {
 public:
  /// Plays the first of `models`; silent without one. Thread: OFF.
  BackgroundLayer(const std::vector<BackgroundModel>& models, double sample_rate, std::uint64_t seed);

  /// The next kChunk samples. Thread: RT.
  void process(const BackgroundControls& controls, double* out) noexcept;

 private:
  double sample_rate_;
  dsp::RandomField random_;
  double model_rpm_ = 0, noise_level_ = 0;
  std::vector<double> cycle_;  ///< one cycle of 720 degrees
  double angle_ = 0;           ///< cycles, 0...1
  double rpm_ = 0, level_ = 0, noise_ = 0;
  std::uint64_t sample_ = 0;
};

}  // namespace rigsound::background
