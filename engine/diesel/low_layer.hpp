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

  /// Makes every angle sample before `end`. A frame is begun as soon as the one before it starts to play and
  /// grows a group at a time, is transformed before its turn and overlapped with the one before it then, so
  /// no block pays for a whole one. Thread: RT.
  void produce(std::int64_t end, const OperatingGrid& grid, const GridPlace& place) noexcept;

  void reset() noexcept;  ///< Silence so far. Thread: RT

  const AngleRing& ring() const noexcept { return ring_; }

 private:
  void transform() noexcept;
  void grow(int groups, const OperatingGrid& grid, const GridPlace& place) noexcept;

  int P_, rows_;
  WaveletTree tree_;
  dsp::Mdct<double> bank_;
  AngleRing ring_;
  int groups_done_ = 0;
  bool transformed_ = false;  ///< bank_ holds the frame
  GridPlace place_;           ///< where the frame was begun
  std::vector<double> deviation_, slice_, X_, overlap_, y_;
};

}  // namespace rigsound::diesel
