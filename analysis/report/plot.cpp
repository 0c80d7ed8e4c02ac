#include "report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigsound::analysis {
namespace {

constexpr double kLeft = 54, kTop = 22, kTicks = 18, kLabel = 16;

/// 0...1 along the axis.
double place(const Axis& axis, double value) {
  const double v = std::clamp(value, axis.low, axis.high);
  if (axis.scale == Axis::Scale::kLog) return std::log(v / axis.low) / std::log(axis.high / axis.low);
  return (v - axis.low) / (axis.high - axis.low);
}

}  // namespace

Axis linear_axis(std::string label, double low, double high, int count) {
  Axis axis{std::move(label), low, high, Axis::Scale::kLinear, {}};
  const double rough = (high - low) / count, decade = std::pow(10, std::floor(std::log10(rough)));
  const double step = decade * (rough / decade < 1.5   ? 1
                                : rough / decade < 3.5 ? 2
                                : rough / decade < 7.5 ? 5
                                                       : 10);
  for (double t = std::ceil(low / step - 1e-9) * step; t <= high + 1e-9 * step; t += step)
    axis.ticks.emplace_back(t, fmt::format("{:g}", std::fabs(t) < 1e-9 * step ? 0 : t));
  return axis;
}

Axis frequency_axis(std::string label, double low, double high, const std::vector<double>& at) {
  Axis axis{std::move(label), low, high, Axis::Scale::kLog, {}};
  for (const double f : at)
    axis.ticks.emplace_back(f, f >= 1000 ? fmt::format("{:g}k", f / 1000) : fmt::format("{:g}", f));
  return axis;
}

Plot::Plot(std::string title, Axis x, Axis y, const PlotSize& size)
    : title_(std::move(title)),
      x_(std::move(x)),
      y_(std::move(y)),
      width_(size.width),
      height_(size.height),
      right_(size.width - size.right),
      bottom_(size.height - kTicks - (x_.label.empty() ? 0 : kLabel)) {}

double Plot::px(double x) const { return kLeft + (right_ - kLeft) * place(x_, x); }
double Plot::py(double y) const { return bottom_ - (bottom_ - kTop) * place(y_, y); }
std::string Plot::point(double x, double y) const { return fmt::format("{:.1f} {:.1f}", px(x), py(y)); }

void Plot::line(const std::vector<double>& x, const std::vector<double>& y, const std::string& css_class) {
  std::string path;
  for (std::size_t i = 0; i < x.size(); ++i) path += (i == 0 ? "M" : "L") + point(x[i], y[i]);
  marks_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>", css_class, path);
}

void Plot::strokes(const std::vector<double>& x, const std::vector<double>& low,
                   const std::vector<double>& high, const std::string& css_class) {
  std::string path;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double top = std::floor(py(high[i])), bottom = std::max(std::ceil(py(low[i])), top + 1);
    path += fmt::format("M{:.0f} {:.0f}V{:.0f}", px(x[i]), top, bottom);
  }
  marks_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>", css_class, path);
}

void Plot::bars(const std::vector<double>& edges, const std::vector<double>& heights,
                const std::string& css_class) {
  std::string path;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (heights[i] > 0)
      path += fmt::format("M{:.1f} {:.1f}V{:.1f}H{:.1f}V{:.1f}Z", px(edges[i]) + 0.5, py(0), py(heights[i]),
                          px(edges[i + 1]) - 0.5, py(0));
  marks_ += fmt::format("<path class=\"area {}\" d=\"{}\"/>", css_class, path);
}

void Plot::verticals(const std::vector<double>& x, const std::string& css_class) {
  std::string path;
  for (const double v : x) path += fmt::format("M{:.1f} {:.0f}V{:.0f}", px(v), kTop, bottom_);
  marks_ += fmt::format("<path class=\"line {}\" d=\"{}\"/>", css_class, path);
}

void Plot::image(const std::string& data_uri) {
  marks_ += fmt::format(
      "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" href=\"{}\"/>", kLeft,
      kTop, right_ - kLeft, bottom_ - kTop, data_uri);
}

void Plot::colour_bar(const std::vector<std::string>& colours, const Axis& scale) {
  const double left = right_ + 10, width = 10, step = (bottom_ - kTop) / static_cast<double>(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
    marks_ += fmt::format("<path fill=\"{}\" d=\"M{} {:.1f}h{}v-{:.1f}h-{}z\"/>", colours[i], left,
                          bottom_ - static_cast<double>(i) * step, width, step, width);
  for (const auto& [value, says] : scale.ticks)
    marks_ += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{:.1f}\">{}</text>", left + width + 4,
                          bottom_ - (bottom_ - kTop) * place(scale, value) + 4, says);
}

void Plot::legend(const std::string& word, const std::string& css_class) {
  legend_ += fmt::format("<tspan dx=\"10\" class=\"{}\">{}</tspan>", css_class, word);
}

std::string Plot::axes() const {
  std::string text =
      fmt::format("<path class=\"axis\" d=\"M{0} {1}V{2}H{3}\"/>", kLeft, kTop, bottom_, right_);
  for (const auto& [value, says] : x_.ticks)
    text += fmt::format(
        "<path class=\"axis\" d=\"M{0:.1f} {1}v4\"/><text class=\"tick x\" x=\"{0:.1f}\" "
        "y=\"{2}\">{3}</text>",
        px(value), bottom_, bottom_ + 15, says);
  for (const auto& [value, says] : y_.ticks)
    text += fmt::format(
        "<path class=\"grid\" d=\"M{0} {1:.1f}H{2}\"/><text class=\"tick y\" x=\"{3}\" "
        "y=\"{4:.1f}\">{5}</text>",
        kLeft, py(value), right_, kLeft - 5, py(value) + 4, says);
  if (!x_.label.empty())
    text += fmt::format("<text class=\"tick x\" x=\"{:.0f}\" y=\"{:.0f}\">{}</text>", (kLeft + right_) / 2,
                        height_ - 4, x_.label);
  if (!y_.label.empty())
    text += fmt::format("<text class=\"tick x\" transform=\"translate(12 {:.0f}) rotate(-90)\">{}</text>",
                        (kTop + bottom_) / 2, y_.label);
  return text;
}

std::string Plot::svg() const {
  return fmt::format(
      "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"{2}\"><text class=\"title\" x=\"{3}\" "
      "y=\"14\">{2}"
      "</text><text class=\"y\" x=\"{4}\" y=\"14\">{5}</text>{6}{7}</svg>\n",
      width_, height_, title_, kLeft, right_, legend_, marks_, axes());
}

}  // namespace rigsound::analysis
