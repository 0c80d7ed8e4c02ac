// A canvas that becomes SVG: inside a page, or a file of its own.
#pragma once

#include <string>

#include "chart/canvas.hpp"

namespace rigsound::chart {

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(double width, double height) : width_(width), height_(height) {}

  void stroke(const std::vector<Run>& runs, const Pen& pen, const std::string& hover = {}) override;
  void fill(const std::vector<Run>& runs, const Paint& paint, const std::string& hover = {}) override;
  void dot(Point centre, double radius, const Paint& paint, const std::string& hover = {}) override;
  void text(Point at, const std::string& text, const Lettering& lettering) override;
  void words(Point end, const std::vector<Word>& words, double size) override;
  void image(const Box& box, const Picture& picture) override;
  /// An estimate: the reader's fonts are not known.
  double text_width(const std::string& text, const Lettering& lettering) const override;

  /// An element for a page that holds chart_styles(). `says`: what it shows, in words. Thread: OFF.
  std::string element(const std::string& says) const;
  /// The whole of a file: light, dark and printed. Thread: OFF.
  std::string document(const std::string& says) const;

 private:
  double width_, height_;
  std::string marks_;
};

}  // namespace rigsound::chart
