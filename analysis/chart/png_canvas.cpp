#include "chart/png_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "chart/picture_png.hpp"

namespace rigsound::chart {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr std::size_t kMostPoints = 32000;  // of one outline: FreeType counts them in 16 bits
constexpr long kStrip = 128;  // pixels; FreeType has room for some hundred edges in a row of pixels

/// What FreeType draws, one contour a run.
struct Contours {
  std::vector<FT_Vector> points;
  std::vector<char> tags;
  std::vector<short> ends;

  void add(FT_Vector p) {
    points.push_back(p);
    tags.push_back(FT_CURVE_TAG_ON);
  }
  void end() { ends.push_back(static_cast<short>(points.size() - 1)); }
  FT_Outline outline() {
    return {static_cast<short>(ends.size()),
            static_cast<short>(points.size()),
            points.data(),
            tags.data(),
            ends.data(),
            FT_OUTLINE_NONE};
  }
};

Run circle(Point centre, double radius, int corners) {
  Run run;
  for (int i = 0; i < corners; ++i)
    run.push_back({centre.x + radius * std::cos(kTwoPi * i / corners),
                   centre.y + radius * std::sin(kTwoPi * i / corners)});
  return run;
}

/// A segment of a stroke as an area; all turn the same way round, so that overlaps stay filled.
Run bar(Point a, Point b, double width) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
  if (length <= 0) return {};
  const double ox = 0.5 * width * dy / length, oy = -0.5 * width * dx / length;
  return {{a.x + ox, a.y + oy}, {b.x + ox, b.y + oy}, {b.x - ox, b.y - oy}, {a.x - ox, a.y - oy}};
}

std::vector<Run> dashed(const Run& run, double dash) {
  std::vector<Run> dashes;
  double walked = 0;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const double dx = run[i].x - run[i - 1].x, dy = run[i].y - run[i - 1].y, length = std::hypot(dx, dy);
    for (double at = 0; at < length;) {
      const double phase = std::fmod(walked + at, 2 * dash),
                   to = std::min(length, at + (phase < dash ? dash : 2 * dash) - phase + 1e-6);
      if (phase < dash)
        dashes.push_back({{run[i - 1].x + dx * at / length, run[i - 1].y + dy * at / length},
                          {run[i - 1].x + dx * to / length, run[i - 1].y + dy * to / length}});
      at = to;
    }
    walked += length;
  }
  return dashes;
}

}  // namespace

PngCanvas::PngCanvas(int width, int height, double scale, Theme theme)
    : width_(width),
      height_(height),
      scale_(scale),
      theme_(theme),
      pixels_(static_cast<std::size_t>(width) * height, colour(Role::kPaper, theme)) {}

FT_Vector PngCanvas::vector(Point p) const {
  return {std::lround(64 * scale_ * p.x), std::lround(64 * (height_ - scale_ * p.y))};
}

void PngCanvas::render(FT_Outline& outline, const Paint& paint) {
  struct Ink {
    PngCanvas& canvas;
    Colour colour;
    double opacity;
  } ink{*this, paint.fixed ? *paint.fixed : colour(paint.role, theme_), paint.opacity};
  FT_Raster_Params params{};
  params.source = &outline;
  params.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP;
  params.user = &ink;
  params.gray_spans = [](int y, int count, const FT_Span* spans, void* user) {
    const Ink& with = *static_cast<Ink*>(user);
    Colour* const row =
        &with.canvas.pixels_[static_cast<std::size_t>(with.canvas.height_ - 1 - y) * with.canvas.width_];
    for (int s = 0; s < count; ++s) {
      const double share = with.opacity * spans[s].coverage / 255;
      const auto mix = [share](std::uint8_t under, std::uint8_t over) {
        return static_cast<std::uint8_t>(std::lround(under + share * (over - under)));
      };
      for (int x = spans[s].x; x < spans[s].x + spans[s].len; ++x)
        row[x] = {mix(row[x].red, with.colour.red), mix(row[x].green, with.colour.green),
                  mix(row[x].blue, with.colour.blue)};
    }
  };
  FT_BBox box;
  FT_Outline_Get_CBox(&outline, &box);
  const long first = std::max(0L, box.xMin / 64 - 1), end = std::min<long>(width_, box.xMax / 64 + 2);
  for (long x = first; x < end; x += kStrip) {
    params.clip_box = {x, 0, std::min(x + kStrip, end), height_};
    if (FT_Outline_Render(font_.library(), &outline, &params) != 0)
      throw std::runtime_error("FreeType cannot render an outline of the picture");
  }
}

void PngCanvas::fill(const std::vector<Run>& runs, const Paint& paint, const std::string&) {
  Contours contours;
  const auto flush = [&] {
    FT_Outline outline = contours.outline();
    if (!contours.ends.empty()) render(outline, paint);
    contours = {};
  };
  for (const Run& run : runs) {
    if (run.size() < 3) continue;
    if (contours.points.size() + run.size() > kMostPoints) flush();
    for (const Point& p : run) contours.add(vector(p));
    contours.end();
  }
  flush();
}

void PngCanvas::stroke(const std::vector<Run>& runs, const Pen& pen, const std::string&) {
  constexpr double kRoundFrom = 1.5;  // pixels; joints of thinner strokes are not seen
  constexpr int kCorners = 8;
  std::vector<Run> areas;
  for (const Run& whole : runs) {
    const std::vector<Run> pieces = pen.dash > 0 ? dashed(whole, pen.dash) : std::vector<Run>{whole};
    for (const Run& run : pieces)
      for (std::size_t i = 1; i < run.size(); ++i) {
        areas.push_back(bar(run[i - 1], run[i], pen.width));
        if (i + 1 < run.size() && pen.width * scale_ >= kRoundFrom)
          areas.push_back(circle(run[i], 0.5 * pen.width, kCorners));
      }
  }
  fill(areas, pen.paint);
}

void PngCanvas::dot(Point centre, double radius, const Paint& paint, const std::string&) {
  constexpr int kCorners = 32;
  fill({circle(centre, radius, kCorners)}, paint);
}

double PngCanvas::text_width(const std::string& text, const Lettering& l) const {
  return font_.width(text, scale_ * l.size, l.weight) / scale_;
}

void PngCanvas::text(Point at, const std::string& text, const Lettering& l) {
  const double share = l.anchor == Lettering::Anchor::kMiddle ? 0.5
                       : l.anchor == Lettering::Anchor::kEnd  ? 1
                                                              : 0;
  const double back = share * text_width(text, l);
  const bool level = l.turn == Lettering::Turn::kLevel;
  const FT_Vector start = vector(level ? Point{at.x - back, at.y} : Point{at.x, at.y + back});
  const FT_Matrix upward{0, -0x10000, 0x10000, 0};
  font_.spell(text, scale_ * l.size, l.weight, [&](FT_Outline& outline) {
    if (!level) FT_Outline_Transform(&outline, &upward);
    FT_Outline_Translate(&outline, start.x, start.y);
    render(outline, l.paint);
  });
}

void PngCanvas::words(Point end, const std::vector<Word>& words, double size) {
  constexpr double kGap = 10;
  double x = end.x;
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    const Lettering bold{word->paint, size, Lettering::Anchor::kEnd, Lettering::Weight::kBold};
    text({x, end.y}, word->text, bold);
    x -= text_width(word->text, bold) + kGap;
  }
}

int PngCanvas::pixels_across(const Box& box) const {
  return static_cast<int>(std::lround(scale_ * box.right) - std::lround(scale_ * box.left));
}

int PngCanvas::pixels_down(const Box& box) const {
  return static_cast<int>(std::lround(scale_ * box.bottom) - std::lround(scale_ * box.top));
}

void PngCanvas::image(const Box& box, const Picture& picture) {
  const int left = static_cast<int>(std::lround(scale_ * box.left)),
            top = static_cast<int>(std::lround(scale_ * box.top));
  const int across = pixels_across(box), down = pixels_down(box),
            rows = static_cast<int>(picture.pixels.size()) / picture.width;
  for (int y = 0; y < down; ++y)
    for (int x = 0; x < across; ++x)
      pixels_[static_cast<std::size_t>(top + y) * width_ + left + x] =
          picture.palette[picture.pixels[static_cast<std::size_t>(y * rows / down) * picture.width +
                                         x * picture.width / across]];
}

void PngCanvas::write(const std::filesystem::path& file) const { write_png(file, pixels_, width_); }

}  // namespace rigsound::chart
