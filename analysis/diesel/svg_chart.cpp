#include "diesel/svg_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {
namespace {

constexpr double kLeft = 58, kRight = 12, kTop = 26, kBottom = 38;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string svg_of(const Chart& chart, double left, double top, double width, double height) {
  const double w = width - kLeft - kRight, h = height - kTop - kBottom;
  const auto along = [&](double x) {
    const double way = chart.logarithmic ? std::log(x / chart.x_from) / std::log(chart.x_to / chart.x_from)
                                         : (x - chart.x_from) / (chart.x_to - chart.x_from);
    return kLeft + w * std::clamp(way, 0.0, 1.0);
  };
  const auto up = [&](double y) {
    return kTop + h * (1 - std::clamp((y - chart.y_from) / (chart.y_to - chart.y_from), 0.0, 1.0));
  };
  std::string svg = fmt::format(
      "<g transform=\"translate({:.0f},{:.0f})\"><text x=\"{:.0f}\" y=\"16\" "
      "font-weight=\"bold\">{}</text>\n",
      left, top, kLeft, escaped(chart.heading));
  for (const double x : chart.x_ticks)
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3:.1f}\" "
        "text-anchor=\"middle\">{4:g}</text>\n",
        along(x), kTop, kTop + h, kTop + h + 14, x);
  for (std::size_t i = 0; i < chart.y_ticks.size(); ++i) {
    const double y = up(chart.y_ticks[i]);
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1:.1f}H{2:.1f}\" stroke=\"#ddd\"/><text x=\"{3:.1f}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5}</text>\n",
        kLeft, y, kLeft + w, kLeft - 5, y + 4,
        chart.y_names.empty() ? fmt::format("{:g}", chart.y_ticks[i]) : escaped(chart.y_names[i]));
  }
  for (const ChartLine& line : chart.lines) {
    std::string path;
    for (std::size_t i = 0; i < line.x.size(); ++i)
      path += line.stems
                  ? fmt::format("M{0:.1f} {1:.1f}V{2:.1f}", along(line.x[i]), kTop + h, up(line.y[i]))
                  : fmt::format("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', along(line.x[i]), up(line.y[i]));
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>\n", path,
                       line.colour, line.width);
  }
  svg += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" stroke=\"#888\"/>\n"
      "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>"
      "<text transform=\"translate(14,{:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text></g>\n",
      kLeft, kTop, w, h, kLeft + w / 2, kTop + h + 30, escaped(chart.x_label), kTop + h / 2,
      escaped(chart.y_label));
  return svg;
}

}  // namespace rigsound::analysis
