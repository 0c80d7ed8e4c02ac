// Where the bending modes of one rod lie at every length of it that may be outside the hole.
#pragma once

#include <vector>

#include "rigsound/string_model.hpp"

namespace rigsound::string {

constexpr int kMaxModes = 112;   ///< in groups of kGroup
constexpr int kGroup = 4;        ///< modes that are computed side by side
constexpr double kShortest = 4;  ///< exposed length in diameters below which nothing is tuned
constexpr double kFadeFrom_hz = 10000, kFadeTo_hz = 12000;  ///< modes fade in between

/// Four rows of the table and their weights: cubic interpolation over the logarithm of the length.
struct TableCut {
  const double* row[4];
  double weight[4];

  double at(int mode) const noexcept {
    return (weight[0] * row[0][mode] + weight[1] * row[1][mode]) +
           (weight[2] * row[2][mode] + weight[3] * row[3][mode]);
  }
};

/// tan(pi f / sample rate) of the modes 1...kMaxModes of a free-free rod, exact Timoshenko, between four
/// diameters and its whole length. Interpolated within 0.06 cents.
class ModeTable {
 public:
  /// Thread: OFF.
  ModeTable(const StringModel& model, double sample_rate);

  /// The table at `length_m`, held within its ends. Thread: RT.
  TableCut cut(double length_m) const noexcept;

 private:
  double low_;  ///< ln of the first row's length
  int rows_;
  std::vector<double> t_;  ///< rows of kMaxModes
};

/// tan(pi hz / sample rate). Thread: any.
double warped(double hz, double sample_rate) noexcept;

}  // namespace rigsound::string
