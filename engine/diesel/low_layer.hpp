// The noise under the crossover: harmonic-band wavelets, one MDCT frame a cycle (L = 1).
#pragma once

#include <cstdint>
#include <vector>

#include "diesel/angle_ring.hpp"
#include "diesel/operating_grid.hpp"
#include "diesel/wavelet_tree.hpp"
#include "rigsound/dsp/mdct.hpp"

namespace rigsound::diesel {

class LowLayer {
 public:
  LowLayer(const DieselModel& model, std::uint64_t seed);  ///< Thread: OFF

  /// Makes every angle sample before `end`. A frame is begun as soon as the one before it starts to play,
  /// grows a group at a time, is transformed a step at a time and overlapped with the one before it in its
  /// turn, so no block pays for a whole one. Thread: RT.
  void produce(std::int64_t end, const OperatingGrid& grid, const GridPlace& place) noexcept;

  void reset() noexcept;  ///< Silence so far. Thread: RT

  const AngleRing& ring() const noexcept { return ring_; }

 private:
  void work(int due, const OperatingGrid& grid, const GridPlace& place) noexcept;
  void grow(int group, const OperatingGrid& grid) noexcept;

  int P_, rows_;
  WaveletTree tree_;
  dsp::Mdct<double> bank_;
  AngleRing ring_;
  int done_ = 0;     ///< of the next frame: groups grown, then steps of its transform
  GridPlace place_;  ///< where it was begun
  std::vector<double> deviation_, slice_, X_, overlap_, y_;
};

}  // namespace rigsound::diesel
