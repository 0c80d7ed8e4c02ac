// The high layer from a clean recording: whole cycles of it, picked at random and overlapped.
#pragma once

#include <cstdint>
#include <vector>

#include "diesel/operating_grid.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::diesel {

/// Each cycle plays one grain of a point near the current speed and load; the point is drawn by the weights,
/// the grain evenly among all but the one before. Equal-power overlap over kGrainOverlap of a cycle.
class GrainSource {
 public:
  GrainSource(const DieselModel& model, std::uint64_t seed);  ///< `model` must outlive it. Thread: OFF

  /// The next M angle samples; M divides the overlap. `rpm`, `load`: where the machine is. Thread: RT.
  void produce(double rpm, double load, double* out) noexcept;

 private:
  void pick(double rpm, double load) noexcept;

  const DieselModel* model_;  // outlives this and every copy
  dsp::RandomField random_;
  int M_, cycle_samples_, overlap_samples_;
  std::vector<double> fade_in_;
  const float *now_ = nullptr, *before_ = nullptr;
  std::size_t last_point_ = 0, last_grain_ = 0;
  int at_ = 0;  // angle samples into the cycle
  std::uint64_t cycle_ = 0;
};

}  // namespace rigsound::diesel
