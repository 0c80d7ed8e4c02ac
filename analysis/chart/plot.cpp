#include "chart/plot.hpp"

#include <algorithm>
#include <cmath>

#include "chart/reduced_line.hpp"

namespace rigsound::chart {
namespace {

constexpr double kTickRoom = 18, kLabelRoom = 16, kTickLength = 4;
constexpr double kTitleSize = 12, kTextSize = 11;

using Anchor = Lettering::Anchor;

Lettering grey(Anchor anchor) { return {Role::kGrey, kTextSize, anchor}; }

}  // namespace

Plot::Plot(Canvas& canvas, const Box& outer, std::string title, Axis x, Axis y, const Margins& margins)
    : canvas_(canvas), outer_(outer), title_(std::move(title)), x_(std::move(x)), y_(std::move(y)) {
  const double bottom =
      margins.bottom >= 0 ? margins.bottom : kTickRoom + (x_.label.empty() ? 0 : kLabelRoom);
  plane_ = {outer.left + margins.left, outer.top + margins.top, outer.right - margins.right,
            outer.bottom - bottom};
}

Run Plot::run(const std::vector<double>& x, const std::vector<double>& y) const {
  Run points;
  for (std::size_t i = 0; i < x.size(); ++i) points.push_back({px(x[i]), py(y[i])});
  return points;
}

void Plot::line(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen) {
  canvas_.stroke({reduced(run(x, y))}, pen);
}

void Plot::steps(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen) {
  Run corners;
  for (const Point& p : run(x, y)) {
    if (!corners.empty()) corners.push_back({p.x, corners.back().y});
    corners.push_back(p);
  }
  if (!corners.empty()) corners.push_back({plane_.right, corners.back().y});
  canvas_.stroke({reduced(corners)}, pen);
}

void Plot::band(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high,
                const Paint& paint) {
  Run edge = run(x, high);
  const Run bottom = run(x, low);
  for (std::size_t i = bottom.size(); i-- > 0;)
    edge.push_back({bottom[i].x, std::max(bottom[i].y, edge[i].y + 1)});
  canvas_.fill({edge}, paint);
}

void Plot::stems(const std::vector<double>& x, const std::vector<double>& y, const Pen& pen) {
  std::vector<Run> strokes;
  for (const Point& p : run(x, y)) strokes.push_back({{p.x, plane_.bottom}, p});
  canvas_.stroke(strokes, pen);
}

void Plot::bars(const std::vector<double>& edges, const std::vector<double>& heights, const Paint& paint) {
  std::vector<Run> all;
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (heights[i] > 0)
      all.push_back(rectangle({px(edges[i]) + 0.5, py(heights[i]), px(edges[i + 1]) - 0.5, py(0)}));
  canvas_.fill(all, paint);
}

void Plot::verticals(const std::vector<double>& x, const Pen& pen) {
  std::vector<Run> all;
  for (const double v : x) all.push_back({{px(v), plane_.top}, {px(v), plane_.bottom}});
  canvas_.stroke(all, pen);
}

void Plot::horizontal(double y, const Pen& pen) {
  canvas_.stroke({{{plane_.left, py(y)}, {plane_.right, py(y)}}}, pen);
}

void Plot::dot(double x, double y, double radius, const Paint& paint, const std::string& hover) {
  canvas_.dot({px(x), py(y)}, radius, paint, hover);
}

void Plot::image(const Picture& picture) {
  constexpr double kOverPicture = 0.18;
  grid_opacity_ = kOverPicture;
  canvas_.image(plane_, picture);
}

void Plot::colour_bar(const std::vector<Colour>& colours, const Axis& scale) {
  constexpr double kGap = 10, kWidth = 10;
  const double left = plane_.right + kGap;
  Picture bar{1, {}, colours};
  for (std::size_t i = colours.size(); i-- > 0;) bar.pixels.push_back(static_cast<std::uint8_t>(i));
  canvas_.image({left, plane_.top, left + kWidth, plane_.bottom}, bar);
  for (const auto& [value, says] : scale.ticks)
    canvas_.text({left + kWidth + 4, plane_.bottom - plane_.height() * scale.place(value) + 4}, says,
                 grey(Anchor::kStart));
  if (!scale.label.empty())
    canvas_.text(
        {left + kWidth + 42, (plane_.top + plane_.bottom) / 2}, scale.label,
        {Role::kGrey, kTextSize, Anchor::kMiddle, Lettering::Weight::kRegular, Lettering::Turn::kUpward});
}

void Plot::legend(const std::string& word, const Paint& paint) { legend_.push_back({word, paint}); }

void Plot::draw_x_axis() {
  std::vector<Run> ticks;
  for (const auto& [value, says] : x_.ticks) {
    ticks.push_back({{px(value), plane_.bottom}, {px(value), plane_.bottom + kTickLength}});
    canvas_.text({px(value), plane_.bottom + 15}, says, grey(Anchor::kMiddle));
  }
  ticks.push_back({{plane_.left, plane_.top}, {plane_.left, plane_.bottom}, {plane_.right, plane_.bottom}});
  canvas_.stroke(ticks, {Role::kGrey});
  if (!x_.label.empty())
    canvas_.text({(plane_.left + plane_.right) / 2, plane_.bottom + kTickRoom + kLabelRoom - 4}, x_.label,
                 grey(Anchor::kMiddle));
}

void Plot::draw_y_axis() {
  std::vector<Run> grid;
  for (const auto& [value, says] : y_.ticks) {
    grid.push_back({{plane_.left, py(value)}, {plane_.right, py(value)}});
    canvas_.text({plane_.left - 5, py(value) + 4}, says, grey(Anchor::kEnd));
  }
  canvas_.stroke(grid, {{Role::kFaint, grid_opacity_}, 0.6});
  if (!y_.label.empty())
    canvas_.text(
        {outer_.left + 12, (plane_.top + plane_.bottom) / 2}, y_.label,
        {Role::kGrey, kTextSize, Anchor::kMiddle, Lettering::Weight::kRegular, Lettering::Turn::kUpward});
}

std::string Plot::description() const {
  std::string text = title_;
  if (!y_.label.empty()) text += ": " + y_.label;
  if (!x_.label.empty()) text += (y_.label.empty() ? ": over " : " over ") + x_.label;
  for (const Word& word : legend_) text += (&word == &legend_.front() ? "; " : ", ") + word.text;
  return text;
}

void Plot::finish() {
  draw_y_axis();
  draw_x_axis();
  if (!title_.empty())
    canvas_.text({plane_.left, plane_.top - 8}, title_,
                 {Role::kInk, kTitleSize, Anchor::kStart, Lettering::Weight::kBold});
  if (!legend_.empty()) canvas_.words({plane_.right, plane_.top - 8}, legend_, kTextSize);
}

}  // namespace rigsound::chart
