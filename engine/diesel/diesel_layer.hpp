// The diesel and its hydraulics: an engine that is never a loop.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "rigsound/diesel_model.hpp"
#include "rigsound/diesel_player.hpp"
#include "rigsound/machine/limits.hpp"

namespace rigsound::diesel {

/// Harmonic-band-wavelet voice in the crank-angle domain: order table + low layer + high layer behind the
/// body filter + free oscillators + hydraulics + recorded start and stop.
class DieselLayer {
 public:
  /// Plays the first of `models`; silent without one. `idle_rpm`: under half of it the engine is starting or
  /// stopping. Throws std::invalid_argument when the model's shape is out of range. Thread: OFF.
  DieselLayer(const std::vector<DieselModel>& models, double sample_rate, std::uint64_t seed,
              double idle_rpm);
  ~DieselLayer();
  DieselLayer(const DieselLayer& other);
  DieselLayer(DieselLayer&&) noexcept;
  /// Takes over another layer of the same model without allocating. Thread: RT.
  DieselLayer& operator=(const DieselLayer& other) noexcept;

  /// The next kChunk samples; false: all of them are zero. Thread: RT.
  bool process(const DieselInput& controls, double* out) noexcept;

  void reset() noexcept;  ///< Filters and what is made ahead, to silence; it turns on. Thread: RT

 private:
  class Voice;
  std::unique_ptr<Voice> voice_;
};

}  // namespace rigsound::diesel
