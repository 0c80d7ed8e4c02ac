#include "contrast/contrast_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "chart/situation_colours.hpp"
#include "chart/svg_plot.hpp"
#include "contrast/psychometric.hpp"

namespace rigsound::analysis {
namespace {

using chart::Axis, chart::Lettering, chart::linear_axis, chart::Plot, chart::Role;

constexpr chart::PlotSize kWide{460, 280}, kSmall{460, 230};
constexpr double kTint = 0.2;

chart::Colour colour_of(Situation situation) {
  return chart::kSituationColours[static_cast<std::size_t>(situation)];
}

Axis feed_axis(const Contrast& c) { return linear_axis("feed pressure, bar", 0, c.plan.highest_bar, 6); }

/// The rig's situations as coloured ground, with their names at the top.
void draw_situations(Plot& plot, chart::Canvas& canvas, const Contrast& c, double low, double high) {
  const SceneOptions& scene = c.plan.scene;
  const struct {
    Situation situation;
    double from_bar, to_bar;
  } spans[] = {{Situation::kUnderfeed, scene.contact_bar, scene.underfeed_bar},
               {Situation::kNormal, scene.underfeed_bar, scene.overfeed_bar},
               {Situation::kOverfeed, scene.overfeed_bar, c.plan.highest_bar}};
  for (const auto& span : spans) {
    plot.band({span.from_bar, span.to_bar}, {low, low}, {high, high}, {colour_of(span.situation), kTint});
    canvas.text({plot.px((span.from_bar + span.to_bar) / 2), plot.plane().top + 13},
                std::string(name(span.situation)), {Role::kGrey, 11, Lettering::Anchor::kMiddle});
  }
}

struct Series {
  std::vector<double> x, y;
};

template <class Value>
Series series(const Contrast& c, Value value) {
  Series s;
  for (const FeedFigures& f : c.feed) s.x.push_back(f.feed_bar), s.y.push_back(value(f));
  return s;
}

/// A chart of its own over the feed: line, dots with their values, ground.
class FeedChart {
 public:
  FeedChart(const Contrast& c, const std::string& title, const Axis& y, const chart::PlotSize& size)
      : contrast_(c),
        canvas_(size.width, size.height),
        plot_(canvas_, {0, 0, size.width, size.height}, title, feed_axis(c), y) {
    draw_situations(plot_, canvas_, c, y.low, y.high);
  }
  FeedChart(const FeedChart&) = delete;  // plot_ draws on canvas_
  FeedChart& operator=(const FeedChart&) = delete;

  Plot& plot() { return plot_; }
  chart::Canvas& canvas() { return canvas_; }

  template <class Value, class Says>
  void draw(Value value, Says says) {
    const Series s = series(contrast_, value);
    plot_.line(s.x, s.y, {Role::kFirst, 1.8});
    for (const FeedFigures& f : contrast_.feed)
      plot_.dot(f.feed_bar, value(f), 2.6, Role::kFirst, fmt::format("{:g} bar: {}", f.feed_bar, says(f)));
  }

  std::string svg() {
    plot_.finish();
    return canvas_.element(plot_.description());
  }

 private:
  const Contrast& contrast_;
  chart::SvgCanvas canvas_;
  Plot plot_;
};

struct SideOfNormal {
  Reach Contrast::*reach;
  Situation situation;
  int sign;
};
constexpr SideOfNormal kSidesOfNormal[] = {{&Contrast::under, Situation::kUnderfeed, -1},
                                           {&Contrast::over, Situation::kOverfeed, 1}};

void draw_fit(Plot& plot, const Contrast& c, const SideOfNormal& side) {
  const Reach& reach = c.*side.reach;
  if (reach.scale_bar <= 0) return;
  const Psychometric curve{reach.scale_bar, reach.slope};
  const double end =
      side.sign > 0 ? c.plan.highest_bar - c.plan.points.normal : c.plan.points.normal - c.plan.lowest_bar;
  std::vector<double> x, y;
  for (double away = 0; away <= end; away += end / 200)
    x.push_back(c.plan.points.normal + side.sign * away), y.push_back(100 * curve.right(away));
  plot.line(x, y, {Role::kInk, 1.6});
}

/// Where three quarters are told, with its interval.
void draw_reach(FeedChart& chart, const Contrast& c, const SideOfNormal& side) {
  const Reach& reach = c.*side.reach;
  if (!reach.found) return;
  Plot& plot = chart.plot();
  const double normal = c.plan.points.normal, level = 100 * kToldRight;
  const double at = normal + side.sign * reach.away_bar;
  const double low = std::min(normal + side.sign * reach.low_bar, normal + side.sign * reach.high_bar),
               high = std::max(normal + side.sign * reach.low_bar, normal + side.sign * reach.high_bar);
  chart.canvas().stroke({{{plot.px(at), plot.plane().bottom}, {plot.px(at), plot.py(level)}}},
                        {Role::kThird, 1.4, 4});
  plot.line({low, high}, {level, level}, {Role::kThird, 4});
  plot.dot(at, level, 5, Role::kThird,
           fmt::format("{:.1f} bar, {:.1f} to {:.1f} with 95 % confidence", at, low, high));
  chart.canvas().text({plot.px(at) + side.sign * 8, plot.plane().bottom - 8}, fmt::format("{:.0f} bar", at),
                      {Role::kThird, 13, side.sign > 0 ? Lettering::Anchor::kStart : Lettering::Anchor::kEnd,
                       Lettering::Weight::kBold});
}

/// An axis that holds every value with a little air.
template <class Value>
Axis axis_over(const Contrast& c, const char* label, double least_span, Value value) {
  double low = 1e9, high = -1e9;
  for (const FeedFigures& f : c.feed) low = std::min(low, value(f)), high = std::max(high, value(f));
  const double air = std::max(0.18 * (high - low), (least_span - (high - low)) / 2);
  return linear_axis(label, std::max(0.0, low - air), high + air, 5);
}

}  // namespace

std::string heard_chart(const Contrast& c) {
  FeedChart chart(c, "Told from normal within one second", linear_axis("% right; 50 is guessing", 40, 105, 6),
                  kWide);
  Plot& plot = chart.plot();
  plot.horizontal(100 * kToldRight, {Role::kGrey, 0.9, 3});
  for (const SideOfNormal& side : kSidesOfNormal) draw_fit(plot, c, side);
  for (const FeedFigures& f : c.feed)
    if (f.of > 0)
      plot.dot(f.feed_bar, 100.0 * f.right / f.of, 3.2, Role::kFirst,
               fmt::format("{:g} bar: {} of {} excerpts right", f.feed_bar, f.right, f.of));
  for (const SideOfNormal& side : kSidesOfNormal) draw_reach(chart, c, side);
  return chart.svg();
}

std::string distance_chart(const Contrast& c) {
  const auto value = [](const FeedFigures& f) { return f.third_octave_db; };
  double most = 0;
  for (const FeedFigures& f : c.feed) most = std::max(most, f.third_octave_db);
  FeedChart chart(c, "Distance from normal, third octaves",
                  linear_axis("dB", 0, 1.2 * std::max(most, 1.0), 5), kWide);
  chart.plot().horizontal(c.floor_db, {Role::kThird, 1.2, 4});
  chart.plot().legend("- - two runs of normal", Role::kThird);
  chart.draw(value, [](const FeedFigures& f) {
    return fmt::format("{:.2f} dB, modulation {:.2f} dB", f.third_octave_db, f.modulation_db);
  });
  return chart.svg();
}

std::string loudness_chart(const Contrast& c) {
  const auto value = [](const FeedFigures& f) { return f.loudness_sone; };
  FeedChart chart(c, "Loudness", axis_over(c, "sone", 4, value), kSmall);
  chart.draw(value, [](const FeedFigures& f) {
    return fmt::format("{:.1f} sone, {:.1f} phon", f.loudness_sone, f.loudness_phon);
  });
  return chart.svg();
}

std::string rate_chart(const Contrast& c) {
  const auto value = [](const FeedFigures& f) { return f.rate_hz; };
  FeedChart chart(c, "Rate", axis_over(c, "impacts a second", 4, value), kSmall);
  chart.draw(value, [](const FeedFigures& f) { return fmt::format("{:.2f} impacts a second", f.rate_hz); });
  return chart.svg();
}

}  // namespace rigsound::analysis
