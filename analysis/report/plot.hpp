// A small chart as inline SVG, coloured by the page's style sheet.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rigsound::analysis {

struct Axis {
  enum class Scale { kLinear, kLog };
  std::string label;
  double low = 0, high = 1;
  Scale scale = Scale::kLinear;
  std::vector<std::pair<double, std::string>> ticks;  ///< where, and what it says
};

/// Ticks at round numbers, about `count` of them, from low to high.
Axis linear_axis(std::string label, double low, double high, int count = 5);

/// An axis of frequencies with ticks at `at` (Hz).
Axis frequency_axis(std::string label, double low, double high, const std::vector<double>& at);

/// Of a chart, in pixels of a page as wide as it is meant to be.
struct PlotSize {
  double width = 0, height = 0;
  double right = 10;  ///< margin beside the plane
};

/// Marks are drawn in the order they are added; `css_class` decides their colour. Points outside the axes are
/// moved to their edge. An axis without a label takes less room. Thread: OFF.
class Plot {
 public:
  Plot(std::string title, Axis x, Axis y, const PlotSize& size);

  void line(const std::vector<double>& x, const std::vector<double>& y, const std::string& css_class);
  /// A stroke from low to high at each x, to whole pixels.
  void strokes(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high,
               const std::string& css_class);
  /// One bar from edge to edge; `edges` has one value more than `heights`.
  void bars(const std::vector<double>& edges, const std::vector<double>& heights,
            const std::string& css_class);
  void verticals(const std::vector<double>& x, const std::string& css_class);
  /// A picture over the whole plane of the plot.
  void image(const std::string& data_uri);
  /// What the colours of the picture stand for, in the right margin: from low to high of `scale`.
  void colour_bar(const std::vector<std::string>& colours, const Axis& scale);
  /// A word in the colour of a curve, above the plot.
  void legend(const std::string& word, const std::string& css_class);

  std::string svg() const;

 private:
  double px(double x) const;
  double py(double y) const;
  std::string point(double x, double y) const;
  std::string axes() const;

  std::string title_;
  Axis x_, y_;
  double width_, height_, right_, bottom_;  ///< the plane ends at right_ and bottom_
  std::string marks_, legend_;
};

}  // namespace rigsound::analysis
