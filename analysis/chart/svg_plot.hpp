// A chart of its own as an SVG element of a page.
#pragma once

#include "chart/plot.hpp"
#include "chart/svg_canvas.hpp"

namespace rigsound::chart {

/// Of a chart, in pixels of a page as wide as it is meant to be.
struct PlotSize {
  double width = 0, height = 0;
  double right = 10;  ///< margin beside the plane
};

/// Thread: OFF.
class SvgPlot {
 public:
  SvgPlot(const std::string& title, Axis x, Axis y, const PlotSize& size)
      : canvas_(size.width, size.height),
        plot_(canvas_, {0, 0, size.width, size.height}, title, std::move(x), std::move(y),
              {Margins().left, Margins().top, size.right}) {}
  SvgPlot(const SvgPlot&) = delete;  // plot_ draws on canvas_
  SvgPlot& operator=(const SvgPlot&) = delete;

  Plot* operator->() { return &plot_; }

  /// Once, when every mark is drawn.
  std::string svg() {
    plot_.finish();
    return canvas_.element(plot_.description());
  }

 private:
  SvgCanvas canvas_;
  Plot plot_;
};

}  // namespace rigsound::chart
