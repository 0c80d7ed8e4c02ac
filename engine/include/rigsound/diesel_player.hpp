// One diesel played by itself: what the engine does with it, without a rig around it.
#pragma once

#include <cstdint>
#include <memory>

#include "rigsound/diesel_model.hpp"

namespace rigsound {

/// What the diesel follows.
struct DieselInput {
  double rpm = 0;   ///< r/min at the end of the chunk, 0: diesel off
  double load = 0;  ///< 0...1
  double feed = 0;  ///< hydraulic pressure, 0...1 of the overfeed threshold
};

class DieselPlayer {
 public:
  /// Never counts as starting or stopping. Throws std::invalid_argument when the model's shape is out of
  /// range. Thread: OFF.
  DieselPlayer(const DieselModel& model, double sample_rate, std::uint64_t seed);
  ~DieselPlayer();
  DieselPlayer(DieselPlayer&&) noexcept;
  DieselPlayer& operator=(DieselPlayer&&) noexcept;

  /// The next kChunk samples. Thread: RT.
  void process(const DieselInput& input, double* out) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rigsound
