// Section 3.6 of the drilling paper, erratum 13: one click cut out of its neighbours by a bounded mask.
#pragma once

#include <vector>

#include "rigsound/analysis/click_train.hpp"

namespace rigsound::analysis {

/// m_i(n) = beta_i a(n - P_i) / g(n) with g = sqrt(sum_j beta_j^2 a^2(n - P_j)): responses of different
/// impacts are independent, so energies add (erratum 12) and the squared masks of all clicks sum to one.
/// Thread: OFF.
class ClickMasks {
 public:
  /// `clicks` must outlive this; `frames` is the length of the signal they lie in.
  ClickMasks(const ClickTrain& clicks, long frames);

  /// Samples until the envelope has fallen by 60 dB, at most six periods and half a second.
  int click_length() const { return static_cast<int>(a_.size()); }

  /// Mask of click i, in [0, 1], from its onset to the end of the click or of the signal.
  std::vector<double> mask(std::size_t i) const;

  /// x m_i from the onset on.
  std::vector<float> extract(const std::vector<float>& x, std::size_t i) const;

 private:
  const ClickTrain& clicks_;
  std::vector<double> a_;  ///< a_n
  std::vector<double> g_;  ///< the combined envelope
};

}  // namespace rigsound::analysis
