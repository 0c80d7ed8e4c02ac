// A small chart in SVG: axes with ticks, lines, a heading.
#pragma once

#include <string>
#include <vector>

namespace rigsound::analysis {

struct ChartLine {
  std::vector<double> x, y;
  std::string colour;
  double width = 1.2;
  bool stems = false;  ///< vertical strokes from the bottom instead of a line
};

struct Chart {
  std::string heading, x_label, y_label;
  double x_from = 0, x_to = 1, y_from = 0, y_to = 1;
  bool logarithmic = false;  ///< x axis
  std::vector<double> x_ticks, y_ticks;
  std::vector<std::string> y_names;  ///< in place of the numbers of y_ticks, when there are any
  std::vector<ChartLine> lines;
};

/// The chart as an SVG group whose upper left corner lies at (left, top). Thread: OFF.
std::string svg_of(const Chart& chart, double left, double top, double width, double height);

}  // namespace rigsound::analysis
