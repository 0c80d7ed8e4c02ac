// A chart: a plane with two axes, marks on it, a title and a legend.
#pragma once

#include <string>
#include <vector>

#include "chart/axis.hpp"
#include "chart/canvas.hpp"

namespace rigsound::chart {

/// Room round the plane for the axes; negative: as much as they need.
struct Margins {
  double left = 54, top = 22, right = 10, bottom = -1;
};

/// Marks are drawn in the order they are added, finish() puts the axes, the title and the legend over them.
/// Points outside the axes are moved to their edge. An axis without a label takes less room. Thread: OFF.
class Plot {
 public:
  /// `outer`: what the chart may cover, margins included. `canvas` outlives the plot.
  Plot(Canvas& canvas, const Box& outer, std::string title, Axis x, Axis y, const Margins& margins = {});

  void line(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen);
  /// Values that stand until the next one comes, the last one until the end of the axis.
  void steps(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen);
  /// The area from low to high at each x, at least one pixel high.
  void band(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high,
            const Paint& paint);
  /// A stroke from the bottom to y at each x.
  void stems(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen);
  /// One bar from edge to edge; `edges` has one value more than `heights`.
  void bars(const std::vector<double>& edges, const std::vector<double>& heights, const Paint& paint);
  void verticals(const std::vector<double>& x, const Pen& pen);
  void horizontal(double y, const Pen& pen);
  void dot(double x, double y, double radius, const Paint& paint, const std::string& hover);
  /// A picture over the whole plane.
  void image(const Picture& picture);
  /// What the colours of the picture stand for, in the right margin: from low to high of `scale`.
  void colour_bar(const std::vector<Colour>& colours, const Axis& scale);
  /// A word in the colour of its marks, above the plane.
  void legend(const std::string& word, const Paint& paint);

  void finish();

  /// The chart in a sentence, for those who do not see it: title, axes, legend.
  std::string description() const;

  const Box& plane() const { return plane_; }
  double px(double x) const { return plane_.left + plane_.width() * x_.place(x); }
  double py(double y) const { return plane_.bottom - plane_.height() * y_.place(y); }

 private:
  Run run(const std::vector<double>& x, const std::vector<double>& y) const;
  void draw_x_axis();
  void draw_y_axis();

  Canvas& canvas_;
  Box outer_, plane_;
  std::string title_;
  Axis x_, y_;
  double grid_opacity_ = 0.55;
  std::vector<Word> legend_;
};

}  // namespace rigsound::chart
