// What charts are drawn on. Lengths are pixels of the drawing, y points down.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "chart/paint.hpp"

namespace rigsound::chart {

struct Point {
  double x, y;
};
using Run = std::vector<Point>;  ///< points joined by straight lines

struct Box {
  double left, top, right, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

struct Pen {
  Paint paint;
  double width = 1;
  double dash = 0;  ///< length of dashes and of the gaps between them; 0: a solid line
};

struct Lettering {
  enum class Anchor : std::uint8_t { kStart, kMiddle, kEnd };
  enum class Weight : std::uint8_t { kRegular, kBold };
  enum class Turn : std::uint8_t { kLevel, kUpward };

  Paint paint = Role::kInk;
  double size = 11;
  Anchor anchor = Anchor::kStart;
  Weight weight = Weight::kRegular;
  Turn turn = Turn::kLevel;
};

/// A picture of up to 256 colours, row by row from the top.
struct Picture {
  int width = 0;
  std::vector<std::uint8_t> pixels;  ///< places in `palette`
  std::vector<Colour> palette;
};

/// A word of a legend and its colour.
struct Word {
  std::string text;
  Paint paint;
};

/// `hover` is shown while the pointer rests on a mark, where the canvas can do that. Text is UTF-8.
/// Thread: OFF.
class Canvas {
 public:
  virtual ~Canvas() = default;

  virtual void stroke(const std::vector<Run>& runs, const Pen& pen, const std::string& hover = {}) = 0;
  /// Closed runs, filled where they are not wound round twice in opposite senses.
  virtual void fill(const std::vector<Run>& runs, const Paint& paint, const std::string& hover = {}) = 0;
  virtual void dot(Point centre, double radius, const Paint& paint, const std::string& hover = {}) = 0;
  /// (x, y) lies on the baseline.
  virtual void text(Point at, const std::string& text, const Lettering& lettering) = 0;
  /// Bold words one after the other, the last one ends at `end`.
  virtual void words(Point end, const std::vector<Word>& words, double size) = 0;
  virtual void image(const Box& box, const Picture& picture) = 0;
  virtual double text_width(const std::string& text, const Lettering& lettering) const = 0;
};

inline Run rectangle(const Box& b) {
  return {{b.left, b.top}, {b.right, b.top}, {b.right, b.bottom}, {b.left, b.bottom}};
}

}  // namespace rigsound::chart
