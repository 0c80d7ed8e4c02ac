// The diesel and its hydraulics: an engine that is never a loop.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "background/background_controls.hpp"
#include "rigsound/background_model.hpp"
#include "rigsound/limits.hpp"

namespace rigsound::background {

/// Harmonic-band-wavelet voice in the crank-angle domain: order table + low layer + high layer behind the
/// body filter + free oscillators + hydraulics + recorded start and stop.
class BackgroundLayer {
 public:
  /// Plays the first of `models`; silent without one. `idle_rpm`: under half of it the engine is starting or
  /// stopping. Throws std::invalid_argument when the model's shape is out of range. Thread: OFF.
  BackgroundLayer(const std::vector<BackgroundModel>& models, double sample_rate, std::uint64_t seed,
                  double idle_rpm);
  ~BackgroundLayer();
  BackgroundLayer(BackgroundLayer&&) noexcept;
  BackgroundLayer& operator=(BackgroundLayer&&) noexcept;

  /// The next kChunk samples. Thread: RT.
  void process(const BackgroundControls& controls, double* out) noexcept;

 private:
  class Voice;
  std::unique_ptr<Voice> voice_;
};

}  // namespace rigsound::background
