#include "rigsound/analysis/background_plot.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diesel/compared_cycles.hpp"
#include "diesel/order_spectrum.hpp"
#include "diesel/svg_chart.hpp"
#include "rigsound/file/atomic_file.hpp"

namespace rigsound::analysis {
namespace {

constexpr double kWidth = 620, kHeight = 300, kHighest_hz = 10000;
constexpr int kSpectrumCycles = 8, kPlayedCycles = 120;
constexpr const char *kRecorded = "#1f4e8c", *kModelled = "#c8501e", *kOrders = "#9bbf9b";

ChartLine spectrum(const CyclicSound& s, const char* colour) {
  const std::vector<double> power = order_spectrum(s.y, s.N, kSpectrumCycles);
  ChartLine line{{}, {}, colour, 0.9, false};
  for (std::size_t b = 1; b < power.size(); ++b) {
    const double f = static_cast<double>(b) / kSpectrumCycles * s.f0;
    if (f < 20 || f > kHighest_hz) continue;
    line.x.push_back(f), line.y.push_back(10 * std::log10(power[b] + 1e-20));
  }
  return line;
}

Chart spectrum_chart(const DieselPoint& point, const CyclicSound* recorded, const CyclicSound& model) {
  Chart chart{fmt::format("{} at {:.0f} r/min: spectrum",
                          std::filesystem::path(point.source).filename().string(), point.rpm),
              "Hz",
              "dB re full scale, 1/8 order",
              20,
              kHighest_hz,
              -120,
              -20,
              true,
              {20, 50, 100, 200, 500, 1000, 2000, 5000, 10000},
              {-120, -100, -80, -60, -40, -20},
              {},
              {}};
  ChartLine orders{{}, {}, kOrders, 1, true};
  for (std::size_t k = 1; k <= point.orders.size() && static_cast<double>(k) * model.f0 < 400; ++k) {
    orders.x.push_back(static_cast<double>(k) * model.f0);
    orders.y.push_back(10 * std::log10(0.5 * static_cast<double>(std::norm(point.orders[k - 1])) + 1e-20));
  }
  chart.lines.push_back(orders);
  if (recorded) chart.lines.push_back(spectrum(*recorded, kRecorded));
  chart.lines.push_back(spectrum(model, kModelled));
  return chart;
}

/// One curve an octave, each a step above the one before.
Chart envelope_chart(const CyclicSound* recorded, const CyclicSound& model) {
  constexpr double kStep = 10;
  Chart chart{"mean power over the cycle in octaves from ... on; a grid step is 10 dB",
              "crank angle, degrees",
              "",
              0,
              720,
              -5,
              5,
              false,
              {0, 90, 180, 270, 360, 450, 540, 630, 720},
              {},
              {},
              {}};
  const std::vector<double> edges = envelope_bands(std::min(kHighest_hz, 0.45 * model.N * model.f0));
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double base = kStep * static_cast<double>(i);
    chart.y_ticks.push_back(base);
    chart.y_names.push_back(fmt::format("{:g} Hz", edges[i]));
    chart.y_to = base + kStep;
    const auto add = [&](const CyclicSound& s, const char* colour) {
      ChartLine line{{}, {}, colour, 1.2, false};
      const std::vector<double> profile = cyclic_envelope(s, edges[i], edges[i + 1]);
      for (std::size_t slot = 0; slot < profile.size(); ++slot) {
        line.x.push_back(720.0 * (static_cast<double>(slot) + 0.5) / kEnvelopeSlots);
        line.y.push_back(base + 10 * std::log10(profile[slot] + 1e-6));
      }
      chart.lines.push_back(line);
    };
    if (recorded) add(*recorded, kRecorded);
    add(model, kModelled);
  }
  return chart;
}

}  // namespace

void write_background_plot(const std::filesystem::path& file, const std::vector<DieselTake>& takes,
                           const DieselModel& model) {
  std::vector<std::string> ignored;
  const std::vector<Section> sections = takes.empty() ? std::vector<Section>() : sections_of(takes, ignored);
  std::string body;
  double top = 30;
  for (std::size_t i = 0; i < model.points.size(); ++i, top += kHeight) {
    const DieselPoint& point = model.points[i];
    CyclicSound recorded;
    if (i < sections.size()) recorded = recorded_cycles(sections[i], point, model.angle_samples);
    const CyclicSound* known = recorded.y.empty() ? nullptr : &recorded;
    const CyclicSound modelled = played_cycles(model, point, kPlayedCycles, 1);
    body += svg_of(spectrum_chart(point, known, modelled), 0, top, kWidth, kHeight);
    body += svg_of(envelope_chart(known, modelled), kWidth, top, kWidth, kHeight);
  }
  write_file(
      file,
      fmt::format(
          "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
          "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"11\">\n"
          "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
          "<text x=\"58\" y=\"20\" font-size=\"14\">{2}: <tspan fill=\"{3}\">recorded</tspan>, "
          "<tspan fill=\"{4}\">modelled</tspan>, <tspan fill=\"{5}\">orders</tspan></text>\n{6}</svg>\n",
          2 * kWidth, top, model.name, kRecorded, kModelled, kOrders, body));
}

}  // namespace rigsound::analysis
