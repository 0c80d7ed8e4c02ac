// The spectrum of a click, coarse enough to be compared with that of another.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "spectrum/frame_pair.hpp"

namespace rigsound::analysis {

/// Energies of two clicks in log-spaced bands between 47 Hz and 24 kHz, as shares of the whole of each. The
/// second may be empty. Thread: OFF, one at a time.
class BandShares {
 public:
  static constexpr int kBands = 24;
  using Shares = Eigen::Array<double, kBands, 1>;

  BandShares();
  std::array<Shares, 2> operator()(const std::vector<float>& first, const std::vector<float>& second);

 private:
  FramePair pair_;
  std::vector<int> edges_;
};

}  // namespace rigsound::analysis
