// The chart kit: what may be left out of a line, where ticks lie, what the two canvases make of it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "chart/axis.hpp"
#include "chart/plot.hpp"
#include "chart/png_canvas.hpp"
#include "chart/reduced_line.hpp"
#include "chart/svg_canvas.hpp"
#include "png_file.hpp"
#include "temporary_folder.hpp"

using namespace rigsound;
using namespace rigsound::chart;

TEST_CASE("a reduced line covers in every column what the line covered, within a pixel") {
  Run line;
  std::uint32_t dice = 1;
  for (int i = 0; i < 50000; ++i) {
    dice = dice * 1664525u + 1013904223u;
    line.push_back({i / 500.0, 200.0 * (dice >> 8) / (1 << 24)});
  }
  const Run kept = reduced(line);
  CHECK(kept.size() <= 200);
  for (int column = 0; column < 100; ++column) {
    double low = 1e9, high = -1e9, kept_low = 1e9, kept_high = -1e9;
    for (const Point& p : line)
      if (std::floor(p.x) == column) low = std::min(low, p.y), high = std::max(high, p.y);
    for (const Point& p : kept)
      if (std::floor(p.x) == column) kept_low = std::min(kept_low, p.y), kept_high = std::max(kept_high, p.y);
    CHECK(kept_low <= low);
    CHECK(kept_low > low - 1);
    CHECK(kept_high >= high);
    CHECK(kept_high < high + 1);
  }
}

TEST_CASE("a line of few points, or one that goes to and fro, stays as it is") {
  const Run sparse{{0, 1}, {3, 2}, {7, 1}}, loop{{0.1, 0}, {0.5, 1}, {0.2, 2}, {0.3, 5}, {0.1, 3}};
  CHECK(reduced(sparse).size() == sparse.size());
  CHECK(reduced(loop).size() == loop.size());
}

TEST_CASE("axes place values and ticks") {
  const Axis log = log_axis("s", 0.01, 1);
  CHECK(log.place(0.1) == doctest::Approx(0.5));
  CHECK(log.place(5) == 1);
  REQUIRE(log.ticks.size() == 7);  // 0.01 0.02 0.05 0.1 0.2 0.5 1
  CHECK(log.ticks[3].second == "0.1");
  const Axis linear = linear_axis("bar", 0, 152, 4);
  REQUIRE(linear.ticks.size() == 4);  // 0 50 100 150
  CHECK(linear.ticks[3].first == doctest::Approx(150));
  CHECK(time_axis("", 0, 600, 10).ticks[1].second == "1:00");
  CHECK(time_axis("", 0, 90, 9).ticks[1].second == "10");
}

TEST_CASE("an SVG file holds its own colours for light, dark and print, and its text cannot break it") {
  SvgCanvas canvas(300, 200);
  Plot plot(canvas, {0, 0, 300, 200}, "a < b & \"c\"", linear_axis("x", 0, 1), linear_axis("y", 0, 1));
  plot.line({0, 1}, {0, 1}, {Role::kFirst});
  plot.dot(0.5, 0.5, 3, Role::kThird, "hover <here>");
  plot.finish();
  const std::string svg = canvas.document(plot.description());
  CHECK(svg.find("aria-label=\"a &lt; b &amp; &quot;c&quot;: y over x\"") != std::string::npos);
  CHECK(svg.find("prefers-color-scheme: dark") != std::string::npos);
  CHECK(svg.find("@media print") != std::string::npos);
  CHECK(svg.find("a &lt; b &amp; &quot;c&quot;") != std::string::npos);
  CHECK(svg.find("<title>hover &lt;here&gt;</title>") != std::string::npos);
  // The line runs from corner to corner of the plane: 54 and 34 pixels are left for the axes.
  CHECK(svg.find("M54 166l236-144") != std::string::npos);
}

TEST_CASE("pixels that an area covers by half are half its colour") {
  test::TemporaryFolder folder;
  PngCanvas canvas(20, 10, 2, Theme::kLight);  // 10 x 5 units of two pixels
  canvas.fill({rectangle({1, 1, 3.25, 4})}, Colour{0, 0, 0});
  canvas.write(folder.path / "a.png");
  const test::PngFile png = test::read_png(folder.path / "a.png");
  REQUIRE(png.width == 20);
  REQUIRE(png.height == 10);
  CHECK(png.at(1, 4).red == 255);
  CHECK(png.at(2, 4).red == 0);
  CHECK(png.at(5, 4).red == 0);
  CHECK(std::abs(png.at(6, 4).red - 127) <= 2);  // covered from 6 to 6.5
  CHECK(png.at(7, 4).red == 255);
  CHECK(png.at(4, 1).red == 255);
  CHECK(png.at(4, 2).red == 0);
}

TEST_CASE("text ends where its width says") {
  test::TemporaryFolder folder;
  PngCanvas canvas(200, 40, 1, Theme::kLight);
  const Lettering bold{Role::kInk, 20, Lettering::Anchor::kEnd, Lettering::Weight::kBold};
  const double width = canvas.text_width("r/min", bold);
  CHECK(width > 40);
  canvas.text({150, 30}, "r/min", bold);
  canvas.write(folder.path / "a.png");
  const test::PngFile png = test::read_png(folder.path / "a.png");
  int first = 200, last = 0;
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 40; ++y)
      if (png.at(x, y).red < 128) first = std::min(first, x), last = std::max(last, x);
  CHECK(first == doctest::Approx(150 - width).epsilon(0.03));
  CHECK(last == doctest::Approx(150).epsilon(0.03));
}
