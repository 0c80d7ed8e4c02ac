// The model on a grid of speeds and loads, computed before the first sample.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "rigsound/diesel_model.hpp"

namespace rigsound::diesel {

/// Of the slots at one speed and load.
struct SlotStatistics {
  std::vector<float> hi;  ///< L x bands: standard deviation of the slot's coefficients
  std::vector<float> s;   ///< L: spread of the logarithm of the slot's power
  double rho = 0;
};

/// Everything the layers play at one speed and load. Neighbours on the grid differ by less than 3 % in speed
/// (0.2 rad between points an octave fifth apart), so mixing them linearly loses less than 0.1 dB; the
/// joining of distant points happened in the order domain when the grid was computed.
struct OperatingState {
  std::vector<float> table;  ///< one cycle of the orders, N_theta samples
  std::vector<float> lo;     ///< standard deviation: of each group of the WaveletTree, (N + 1) x its channels
  std::shared_ptr<const SlotStatistics> slots;  ///< the same for all speeds at which the model is held
};

/// Up to four neighbours and their weights, which sum to 1.
struct GridPlace {
  std::array<int, 4> index{};
  std::array<double, 4> weight{};
};

class OperatingGrid {
 public:
  /// Thread: OFF.
  OperatingGrid(const DieselModel& model, double sample_rate);

  GridPlace place(double rpm, double load) const noexcept;  ///< held outside the grid. Thread: RT.
  const OperatingState& state(int index) const noexcept { return states_[static_cast<std::size_t>(index)]; }

  /// sum over the neighbours of `member`[i], for i = first ... first + count - 1. Thread: RT.
  void mix(const GridPlace& place, std::vector<float> OperatingState::*member, int first, int count,
           double* out) const noexcept;
  void mix(const GridPlace& place, std::vector<float> SlotStatistics::*member, int first, int count,
           double* out) const noexcept;
  /// The same of their tables, in float. Thread: RT.
  void table(const GridPlace& place, int first, int count, float* out) const noexcept;
  double rho(const GridPlace& place) const noexcept;

 private:
  double rpm_min_;
  int speeds_ = 1;
  std::vector<double> loads_;
  std::vector<OperatingState> states_;  // load by load, speed by speed
};

}  // namespace rigsound::diesel
