#include "rigsound/analysis/tool_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rigsound::analysis {
namespace {

constexpr double kLeft = 70, kRight = 880, kWidth = 900, kHeight = 620;
constexpr double kLowest_hz = 50, kHighest_hz = 20000;

struct Panel {
  double top, bottom, low, high;
  bool logarithmic;
  std::string label;
  std::vector<double> ticks;

  double y(double value) const {
    const auto scale = [this](double v) { return logarithmic ? std::log(v) : v; };
    const double share = (scale(std::clamp(value, low, high)) - scale(low)) / (scale(high) - scale(low));
    return bottom - share * (bottom - top);
  }
};

double x_of(double hz) {
  return kLeft + (kRight - kLeft) * std::log(hz / kLowest_hz) / std::log(kHighest_hz / kLowest_hz);
}

const char* colour(const TunedMode& mode) { return mode.family == "transversal" ? "#1f5fa8" : "#c2571a"; }

std::string axes(const Panel& p) {
  std::string svg =
      fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n",
                  kLeft, p.top, kRight - kLeft, p.bottom - p.top);
  for (const double hz : {100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0})
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\">{4:g}</text>\n",
        x_of(hz), p.top, p.bottom, p.bottom + 16, hz);
  for (const double tick : p.ticks)
    svg += fmt::format(
        "<path d=\"M{0} {2:.1f}H{1}\" stroke=\"#ddd\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:g}</text>\n",
        kLeft, kRight, p.y(tick), kLeft - 6, p.y(tick) + 4, tick);
  return svg + fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", kLeft, p.top - 8, p.label);
}

/// A line per wanted mode, a dot where the loop has it.
std::string tuning_panel(const std::vector<TunedMode>& modes, const Panel& p) {
  std::string svg = axes(p);
  for (const TunedMode& mode : modes)
    svg += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"{3}\" stroke-opacity=\"0.35\"/>"
        "<circle cx=\"{4:.1f}\" cy=\"{5:.1f}\" r=\"3.5\" fill=\"{3}\"><title>{6} {7}: wanted {8:.2f} "
        "Hz, reached {9:.2f} Hz, {10:+.3f} cents</title></circle>\n",
        x_of(mode.target_hz), p.top, p.bottom, colour(mode), x_of(mode.model_hz), p.y(mode.error_cents),
        mode.family, mode.mode, mode.target_hz, mode.model_hz, mode.error_cents);
  return svg;
}

std::string decay_panel(const std::vector<TunedMode>& modes, const Panel& p) {
  std::string svg = axes(p);
  for (const std::string_view family : {"transversal", "longitudinal"}) {
    std::string line;
    for (const TunedMode& mode : modes) {
      if (mode.family != family) continue;
      line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x_of(mode.model_hz), p.y(mode.t60_s));
      svg += fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"><title>{} {}: {:.4f} s</title>"
          "</circle>\n",
          x_of(mode.model_hz), p.y(mode.t60_s), colour(mode), family, mode.mode, mode.t60_s);
      if (&mode == &modes.back() || (&mode + 1)->family != family)
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", line, colour(mode));
    }
  }
  return svg;
}

/// Whole decades around what there is.
Panel decay_axes(const std::vector<TunedMode>& modes) {
  double shortest = 1e9, longest = 0;
  for (const TunedMode& mode : modes)
    shortest = std::min(shortest, mode.t60_s), longest = std::max(longest, mode.t60_s);
  const double low = std::floor(std::log10(shortest)),
               high = std::max(low + 1, std::ceil(std::log10(longest)));
  std::vector<double> ticks;
  for (double decade = low; decade <= high; ++decade)
    for (const double step : {1.0, 2.0, 5.0})
      if (step == 1 || decade < high) ticks.push_back(step * std::pow(10, decade));
  return {350, 570, ticks.front(), ticks.back(), true, "T60 of the free tool, s", ticks};
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return safe;
}

}  // namespace

std::string tool_plot_svg(std::string_view title, const std::vector<TunedMode>& modes) {
  double worst = 0.1;
  for (const TunedMode& mode : modes) worst = std::max(worst, std::fabs(mode.error_cents));
  const double span = worst <= 1 ? 1 : std::ceil(worst);
  const Panel tuning{60,
                     280,
                     -span,
                     span,
                     false,
                     "error of each mode, cents (line: wanted, dot: reached)",
                     {-span, -span / 2, 0, span / 2, span}};
  const Panel decay = decay_axes(modes);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
      "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n"
      "<text x=\"{4}\" y=\"24\" text-anchor=\"end\"><tspan fill=\"#1f5fa8\">transversal</tspan> "
      "<tspan fill=\"#c2571a\">longitudinal</tspan></text>\n{5}{6}"
      "<text x=\"{7}\" y=\"{8}\" text-anchor=\"middle\">frequency, Hz</text>\n</svg>\n",
      kWidth, kHeight, kLeft, escaped(title), kRight, tuning_panel(modes, tuning), decay_panel(modes, decay),
      (kLeft + kRight) / 2, kHeight - 10);
}

}  // namespace rigsound::analysis
