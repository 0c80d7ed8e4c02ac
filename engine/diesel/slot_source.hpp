// The high layer without grains: white coefficients, weighed per slot of the cycle.
#pragma once

#include <cstdint>
#include <vector>

#include "diesel/operating_grid.hpp"
#include "rigsound/dsp/mdct.hpp"
#include "rigsound/dsp/random.hpp"

namespace rigsound::diesel {

/// One MDCT frame of M coefficients a slot: X[q] = u sqrt(v(l, q)) exp((s z - s^2 / 2) / 2), u uniform with
/// unit variance, z normal and correlated from slot to slot. Whitened: the body is still to come.
class SlotSource {
 public:
  SlotSource(const DieselModel& model, double sample_rate, std::uint64_t seed);  ///< Thread: OFF

  /// The next M angle samples. `f`: cycles a second; what would fold over is left out. Thread: RT.
  void produce(const OperatingGrid& grid, const GridPlace& place, double f, double* out) noexcept;

  void reset() noexcept;  ///< Silence so far. Thread: RT

 private:
  int L_, M_, bands_;
  double sample_rate_;
  dsp::RandomField random_;
  dsp::Mdct<double> bank_;
  std::vector<int> edges_;
  std::vector<double> deviation_, X_, overlap_;
  double z_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace rigsound::diesel
