#include "chart/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "chart/markup_text.hpp"
#include "chart/picture_png.hpp"
#include "chart/style_sheet.hpp"

namespace rigsound::chart {
namespace {

constexpr double kUsualSize = 11;  // of text, said once in the svg element

enum class Use : char { kStroke = 's', kFill = 'f' };

/// In tenths of a pixel.
long tenths(double v) { return std::lround(10 * v); }

std::string number(long tenths) {
  const long whole = std::abs(tenths) / 10, part = std::abs(tenths) % 10;
  std::string text = tenths < 0 ? "-" : "";
  if (whole > 0 || part == 0) text += std::to_string(whole);
  if (part > 0) text += "." + std::to_string(part);
  return text;
}

/// Steps from point to point are shorter than their places, and whole tenths add up without error.
std::string path_data(const std::vector<Run>& runs, const char* end) {
  std::string data;
  for (const Run& run : runs) {
    long x = 0, y = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
      const long to_x = tenths(run[i].x), to_y = tenths(run[i].y), dx = to_x - x, dy = to_y - y;
      if (i == 0)
        data += "M" + number(to_x) + " " + number(to_y);
      else if (dx == 0)
        data += "v" + number(dy);
      else if (dy == 0)
        data += "h" + number(dx);
      else
        data += "l" + number(dx) + (dy < 0 ? "" : " ") + number(dy);
      x = to_x, y = to_y;
    }
    data += end;
  }
  return data;
}

std::string painted(const Paint& paint, Use use) {
  const char* property = use == Use::kStroke ? "stroke" : "fill";
  std::string attributes = paint.fixed
                               ? fmt::format(" style=\"{}:{}\"", property, hex(*paint.fixed))
                               : fmt::format(" class=\"{}{}\"", static_cast<char>(use), name(paint.role));
  if (paint.opacity < 1) attributes += fmt::format(" {}-opacity=\"{:g}\"", property, paint.opacity);
  return attributes;
}

std::string closed(const char* element, const std::string& hover) {
  return hover.empty() ? "/>\n" : fmt::format("><title>{}</title></{}>\n", markup_text(hover), element);
}

const char* anchor_of(Lettering::Anchor anchor) {
  return anchor == Lettering::Anchor::kMiddle ? " text-anchor=\"middle\""
         : anchor == Lettering::Anchor::kEnd  ? " text-anchor=\"end\""
                                              : "";
}

}  // namespace

void SvgCanvas::stroke(const std::vector<Run>& runs, const Pen& pen, const std::string& hover) {
  marks_ += fmt::format("<path{}", painted(pen.paint, Use::kStroke));
  if (pen.width != 1) marks_ += fmt::format(" stroke-width=\"{:g}\"", pen.width);
  if (pen.dash > 0) marks_ += fmt::format(" stroke-dasharray=\"{:g}\"", pen.dash);
  marks_ += fmt::format(" d=\"{}\"{}", path_data(runs, ""), closed("path", hover));
}

void SvgCanvas::fill(const std::vector<Run>& runs, const Paint& paint, const std::string& hover) {
  marks_ += fmt::format("<path{} d=\"{}\"{}", painted(paint, Use::kFill), path_data(runs, "z"),
                        closed("path", hover));
}

void SvgCanvas::dot(Point centre, double radius, const Paint& paint, const std::string& hover) {
  marks_ += fmt::format("<circle{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\"{}", painted(paint, Use::kFill),
                        centre.x, centre.y, radius, closed("circle", hover));
}

void SvgCanvas::text(Point at, const std::string& text, const Lettering& l) {
  const std::string place =
      l.turn == Lettering::Turn::kLevel
          ? fmt::format("x=\"{}\" y=\"{}\"", number(tenths(at.x)), number(tenths(at.y)))
          : fmt::format("transform=\"translate({:.1f} {:.1f}) rotate(-90)\"", at.x, at.y);
  marks_ +=
      fmt::format("<text {}{}{}{}{}>{}</text>\n", place, painted(l.paint, Use::kFill), anchor_of(l.anchor),
                  l.size == kUsualSize ? "" : fmt::format(" font-size=\"{:g}\"", l.size),
                  l.weight == Lettering::Weight::kBold ? " font-weight=\"600\"" : "", markup_text(text));
}

void SvgCanvas::words(Point end, const std::vector<Word>& words, double size) {
  marks_ += fmt::format(
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" font-size=\"{:g}\" font-weight=\"600\">", end.x,
      end.y, size);
  for (const Word& word : words)
    marks_ += fmt::format("<tspan{}{}>{}</tspan>", &word == &words.front() ? "" : " dx=\"10\"",
                          painted(word.paint, Use::kFill), markup_text(word.text));
  marks_ += "</text>\n";
}

void SvgCanvas::image(const Box& box, const Picture& picture) {
  marks_ += fmt::format(
      "<image x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" preserveAspectRatio=\"none\" "
      "href=\"{}\"/>\n",
      box.left, box.top, box.width(), box.height(), png_data_uri(picture));
}

double SvgCanvas::text_width(const std::string& text, const Lettering& l) const {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
  return 0.58 * l.size * static_cast<double>(letters);
}

std::string SvgCanvas::element(const std::string& says) const {
  return fmt::format(
      "<svg viewBox=\"0 0 {:g} {:g}\" font-size=\"11\" role=\"img\" aria-label=\"{}\">{}</svg>\n", width_,
      height_, markup_text(says), marks_);
}

std::string SvgCanvas::document(const std::string& says) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" font-size=\"11\" width=\"{0:g}\" height=\"{1:g}\" "
      "viewBox=\"0 0 {0:g} {1:g}\" role=\"img\" aria-label=\"{4}\">\n<title>{4}</title>\n"
      "<style>svg{{color-scheme:light dark}}{2}</style>\n<rect class=\"fpaper\" width=\"100%\" "
      "height=\"100%\"/>\n{3}</svg>\n",
      width_, height_, chart_styles(), marks_, markup_text(says));
}

}  // namespace rigsound::chart
