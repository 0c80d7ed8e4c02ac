#include "rigsound/analysis/background_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "chart/plot.hpp"
#include "chart/svg_canvas.hpp"
#include "diesel/compared_cycles.hpp"
#include "diesel/cyclic_spectrum.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
namespace {

using chart::Paint, chart::Plot, chart::Role;

constexpr double kSpectrumWidth = 500,
                 kEnvelopeWidth = 640;  // the latter: 9 pixels a slot, which keeps the file short
constexpr double kPanelWidth = kSpectrumWidth + kEnvelopeWidth, kPanelHeight = 300, kPanelHead = 62;
constexpr int kPlayedCycles = 120;
constexpr std::size_t kMostRows = 12;  // speeds, about 15 kB each
// The recorded curve is the wide pale one behind the modelled one, so that both stay visible.
constexpr double kRecordedWidth = 3, kModelledWidth = 1.1;
const Paint kRecorded = Role::kSecond, kModelled = Role::kThird, kOrders{Role::kOnset, 0.45};

/// The model at one speed, and the recording and how far it is off when there is one.
struct Compared {
  CyclicSound model;
  std::optional<CyclicSound> recorded;
  std::optional<Likeness> off;
};

/// As the model has them, before its voice plays.
Curve orders(const DieselPoint& point, double f0) {
  return order_levels({point.orders.begin(), point.orders.end()}, f0);
}

void draw_spectrum(chart::Canvas& canvas, const chart::Box& box, const DieselPoint& point,
                   const Compared& sounds) {
  const auto& [model, recorded, off] = sounds;
  Plot plot(
      canvas, box,
      fmt::format("{} at {:.0f} r/min", std::filesystem::path(point.source).filename().string(), point.rpm),
      chart::frequency_axis("frequency, Hz", kLowestShown_hz, kHighestShown_hz,
                            {20, 50, 100, 200, 500, 1000, 2000, 5000, 10000}),
      chart::linear_axis("dB re full scale, 1/8 order", -120, -20));
  const Curve marked = orders(point, model.f0), modelled = band_levels(model);
  plot.stems(marked.x, marked.y, {kOrders});
  if (recorded) {
    const Curve heard = band_levels(*recorded);
    plot.line(heard.x, heard.y, {kRecorded, kRecordedWidth});
  }
  plot.line(modelled.x, modelled.y, {kModelled, 0.5 * kModelledWidth});
  if (off) plot.legend(fmt::format("third octaves off by {:.1f} dB rms", off->third_octave_db), Role::kGrey);
  plot.finish();
}

/// One curve an octave, each a step above the one before.
void draw_envelopes(chart::Canvas& canvas, const chart::Box& box, const Compared& sounds) {
  const auto& [model, recorded, off] = sounds;
  constexpr double kStep_db = 10;
  const std::vector<double> bands = envelope_bands(std::min(kHighestShown_hz, 0.45 * model.N * model.f0));
  const auto count = static_cast<double>(bands.size() - 1);
  chart::Axis angle{"crank angle, degrees", 0, 720, chart::Axis::Scale::kLinear, {}},
      octaves{"octave from … Hz", -0.5 * kStep_db, (count - 0.5) * kStep_db, chart::Axis::Scale::kLinear, {}};
  for (int degrees = 0; degrees <= 720; degrees += 90)
    angle.ticks.emplace_back(degrees, std::to_string(degrees));
  for (std::size_t i = 0; i + 1 < bands.size(); ++i)
    octaves.ticks.emplace_back(kStep_db * static_cast<double>(i), fmt::format("{:g}", bands[i]));
  Plot plot(canvas, box, "Mean power over the cycle", angle, octaves);
  const auto draw = [&](const CyclicSound& s, const chart::Pen& pen) {
    for (std::size_t i = 0; i + 1 < bands.size(); ++i) {
      const std::vector<double> profile = cyclic_envelope(s, bands[i], bands[i + 1]);
      Curve curve;
      for (std::size_t slot = 0; slot < profile.size(); ++slot) {
        curve.x.push_back(720.0 * (static_cast<double>(slot) + 0.5) / kEnvelopeSlots);
        curve.y.push_back(kStep_db * static_cast<double>(i) + 10 * std::log10(profile[slot] + 1e-6));
      }
      plot.line(curve.x, curve.y, pen);
    }
  };
  if (recorded) draw(*recorded, {kRecorded, kRecordedWidth});
  draw(model, {kModelled, kModelledWidth});
  if (off) plot.legend(fmt::format("off by {:.1f} dB rms,", off->cyclic_envelope_db), Role::kGrey);
  plot.legend(fmt::format("grid step {:.0f} dB", kStep_db), Role::kGrey);
  plot.finish();
}

/// Of all points, evenly spread, the first and the last among them.
std::vector<std::size_t> shown(std::size_t points) {
  const std::size_t rows = std::min(points, kMostRows);
  std::vector<std::size_t> list;
  for (std::size_t row = 0; row < rows; ++row)
    list.push_back(rows == 1 ? 0 : (row * (points - 1) + (rows - 1) / 2) / (rows - 1));
  return list;
}

void draw_head(chart::Canvas& canvas, const std::string& name, std::size_t rows, std::size_t points) {
  constexpr double kNameSize = 16, kLegendSize = 12, kLine = 28, kNoteLine = 46;
  canvas.text({54, kLine},
              rows == points ? fmt::format("Diesel {}: {} speeds", name, points)
                             : fmt::format("Diesel {}: {} of {} speeds", name, rows, points),
              {Role::kInk, kNameSize, chart::Lettering::Anchor::kStart, chart::Lettering::Weight::kBold});
  canvas.words(
      {kPanelWidth - 10, kLine},
      {{"▬ recorded", Role::kGrey}, {"─ modelled", kModelled}, {"│ orders of the model", Role::kOnset}},
      kLegendSize);
  canvas.text(
      {54, kNoteLine},
      "Left: power in bands of 1/8 order of the crank. Right: two turns of it, one curve an octave, each a "
      "grid step above the one before. Off by: rms difference of recorded and modelled.",
      {Role::kGrey});
}

}  // namespace

void write_background_plot(const std::filesystem::path& file, const std::vector<DieselTake>& takes,
                           const DieselModel& model) {
  std::vector<std::string> ignored;
  const std::vector<Section> sections = takes.empty() ? std::vector<Section>() : sections_of(takes, ignored);
  const std::vector<std::size_t> rows = shown(model.points.size());
  chart::SvgCanvas canvas(kPanelWidth, kPanelHead + kPanelHeight * static_cast<double>(rows.size()));
  draw_head(canvas, model.name, rows.size(), model.points.size());
  double top = kPanelHead;
  for (const std::size_t i : rows) {
    const DieselPoint& point = model.points[i];
    Compared sounds{played_cycles(model, point, kPlayedCycles, 1), {}, {}};
    if (i < sections.size()) {
      sounds.recorded = recorded_cycles(sections[i], point, model.angle_samples);
      if (sounds.recorded->y.empty()) sounds.recorded.reset();
    }
    if (sounds.recorded) sounds.off = likeness(*sounds.recorded, sounds.model, kHighestShown_hz);
    const double bottom = top + kPanelHeight - 6;
    draw_spectrum(canvas, {0, top, kSpectrumWidth, bottom}, point, sounds);
    draw_envelopes(canvas, {kSpectrumWidth, top, kPanelWidth, bottom}, sounds);
    top += kPanelHeight;
  }
  write_file(file, canvas.document(fmt::format(
                       "Diesel {}: spectrum and power over the cycle, recorded and modelled", model.name)));
}

}  // namespace rigsound::analysis
