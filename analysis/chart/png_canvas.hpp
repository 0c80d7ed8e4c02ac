// A canvas of pixels.
#pragma once

#include <filesystem>

#include "chart/canvas.hpp"
#include "chart/font.hpp"

namespace rigsound::chart {

/// Lengths are given in the units of the drawing, of which one is `scale` pixels; edges are smoothed.
/// Errors: DeviceError when the machine lacks the font. Thread: OFF.
class PngCanvas final : public Canvas {
 public:
  /// `width` and `height` in pixels.
  PngCanvas(int width, int height, double scale, Theme theme);

  void stroke(const std::vector<Run>& runs, const Pen& pen, const std::string& hover = {}) override;
  void fill(const std::vector<Run>& runs, const Paint& paint, const std::string& hover = {}) override;
  void dot(Point centre, double radius, const Paint& paint, const std::string& hover = {}) override;
  void text(Point at, const std::string& text, const Lettering& lettering) override;
  void words(Point end, const std::vector<Word>& words, double size) override;
  void image(const Box& box, const Picture& picture) override;
  double text_width(const std::string& text, const Lettering& lettering) const override;

  int pixels_across(const Box& box) const;
  int pixels_down(const Box& box) const;

  /// Errors: DeviceError. The file is overwritten.
  void write(const std::filesystem::path& file) const;

 private:
  void render(FT_Outline& outline, const Paint& paint);
  FT_Vector vector(Point p) const;

  int width_, height_;
  double scale_;
  Theme theme_;
  Font font_;
  std::vector<Colour> pixels_;
};

}  // namespace rigsound::chart
