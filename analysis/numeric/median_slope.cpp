#include "numeric/median_slope.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {

double median_slope(const std::vector<LinePoint>& points, double least_apart) {
  struct PairSlope {
    double slope, weight;
  };
  std::vector<PairSlope> pairs;
  double total = 0;
  for (std::size_t j = 1; j < points.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const double dx = points[j].x - points[i].x;
      if (std::fabs(dx) <= least_apart) continue;
      pairs.push_back({(points[j].y - points[i].y) / dx, std::fabs(dx)});
      total += std::fabs(dx);
    }
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.slope < b.slope; });
  double passed = 0;
  for (const PairSlope& pair : pairs) {
    passed += pair.weight;
    if (passed >= 0.5 * total) return pair.slope;
  }
  return 0;
}

}  // namespace rigsound::analysis
