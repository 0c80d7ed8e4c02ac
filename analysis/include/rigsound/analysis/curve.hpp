// A line of a picture, as numbers.
#pragma once

#include <vector>

namespace rigsound::analysis {

struct Curve {
  std::vector<double> x, y;  ///< of equal length
};

}  // namespace rigsound::analysis
