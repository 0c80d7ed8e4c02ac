// A waveform reduced to what a screen can show of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigsound::chart {

/// Lowest and highest sample of each column.
struct Outline {
  std::vector<double> x, low, high;
  double peak = 1e-9;  ///< largest magnitude
};

/// `count` samples in at most `columns`; x starts at `start` and goes on by `per_sample`. Thread: OFF.
inline Outline outline(const float* samples, std::size_t count, std::size_t columns, double start,
                       double per_sample) {
  Outline o;
  columns = std::min(columns, count);
  for (std::size_t c = 0; c < columns; ++c) {
    const std::size_t from = count * c / columns, to = count * (c + 1) / columns;
    const auto [low, high] = std::minmax_element(samples + from, samples + to);
    o.x.push_back(start + 0.5 * static_cast<double>(from + to) * per_sample);
    o.low.push_back(*low);
    o.high.push_back(*high);
    o.peak = std::max({o.peak, o.high.back(), -o.low.back()});
  }
  return o;
}

}  // namespace rigsound::chart
