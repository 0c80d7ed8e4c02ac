// Flat tops: what a recorder could not hold.
#pragma once

#include <cstddef>
#include <vector>

namespace rigsound::analysis {

/// Counts the samples on tops at least two samples wide, at the highest level there is, full scale or below.
/// Measure at the recorder's own rate: another rate rounds them. Thread: OFF.
class FlatTops {
 public:
  explicit FlatTops(float peak);  ///< the highest magnitude of all samples, full scale 1

  void add(const std::vector<float>& piece);
  double share() const;  ///< of all that were added, 0...1

 private:
  float level_;
  std::size_t samples_ = 0, clipped_ = 0;
  std::size_t width_ = 0;  ///< of the top that the last sample lies on
};

}  // namespace rigsound::analysis
