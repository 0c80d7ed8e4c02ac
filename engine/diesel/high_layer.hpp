// The noise over the crossover, still without the body: slots, or grains where the model has them.
#pragma once

#include <optional>
#include <vector>

#include "diesel/angle_ring.hpp"
#include "diesel/grain_source.hpp"
#include "diesel/slot_source.hpp"

namespace rigsound::diesel {

/// Where the machine is: grid place for what is interpolated, plain numbers for what is picked.
struct OperatingPoint {
  GridPlace place;
  double rpm = 0, load = 0;
};

class HighLayer {
 public:
  /// Grains play when every point has some. Thread: OFF.
  HighLayer(const DieselModel& model, double sample_rate, std::uint64_t seed);

  /// Makes every angle sample before `end`, a slot at a time. Thread: RT.
  void produce(std::int64_t end, const OperatingGrid& grid, const OperatingPoint& at) noexcept;

  void reset() noexcept;  ///< Silence so far. Thread: RT

  const AngleRing& ring() const noexcept { return ring_; }

 private:
  std::optional<SlotSource> slots_;
  std::optional<GrainSource> grains_;
  AngleRing ring_;
  std::vector<double> slot_;
};

}  // namespace rigsound::diesel
