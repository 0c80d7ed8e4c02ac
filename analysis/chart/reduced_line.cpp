#include "chart/reduced_line.hpp"

#include <algorithm>
#include <cmath>

namespace rigsound::chart {

Run reduced(const Run& line) {
  const auto by_x = [](const Point& a, const Point& b) { return a.x < b.x; };
  if (line.size() < 3 || !std::is_sorted(line.begin(), line.end(), by_x)) return line;
  Run kept;
  for (auto from = line.begin(); from != line.end();) {
    const double column = std::floor(from->x);
    const auto to = std::find_if(from, line.end(), [&](const Point& p) { return p.x >= column + 1; });
    if (to - from == 1) {
      kept.push_back(*from);
    } else {
      auto [low, high] =
          std::minmax_element(from, to, [](const Point& a, const Point& b) { return a.y < b.y; });
      if (high < low) std::swap(low, high);
      // Whole pixels: outwards, so that the stroke covers what the line covered.
      const double sense = low->y < high->y ? 1 : -1;
      kept.push_back({column + 0.5, sense * std::floor(sense * low->y)});
      if (high->y != low->y) kept.push_back({column + 0.5, sense * std::ceil(sense * high->y)});
    }
    from = to;
  }
  return kept;
}

}  // namespace rigsound::chart
