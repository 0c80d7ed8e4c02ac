// Panels of single clicks: the fitted envelope, and the clicks of the bank.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "chart/outline.hpp"
#include "clicks/envelope.hpp"
#include "clicks/gaps.hpp"
#include "clicks/whitening.hpp"
#include "report/panels.hpp"
#include "rigsound/analysis/rate.hpp"

namespace rigsound::analysis {
namespace {

using chart::linear_axis, chart::Outline, chart::outline, chart::Role, chart::SvgPlot;

constexpr std::size_t kClickColumns = 120;
constexpr double kEnvelopeRangeDb = 50;
constexpr int kEnvelopeBlock = 24;  // samples, half a millisecond
constexpr int kWhitenerOrder = 64;

using PowerCourse = std::vector<double>;  // power of each block after an onset

/// Mean over all clicks, up to one period.
PowerCourse mean_course(const std::vector<int>& P, const std::vector<float>& x) {
  PowerCourse power(static_cast<std::size_t>(median_gap(P) / kEnvelopeBlock), 0.0);
  for (const int onset : P)
    for (std::size_t n = 0; n < power.size() * kEnvelopeBlock && onset + n < x.size(); ++n)
      power[n / kEnvelopeBlock] += static_cast<double>(x[onset + n]) * x[onset + n];
  return power;
}

/// What the fitted train predicts for the same blocks: its own click and the tails of those before.
PowerCourse fitted_course(const ClickEnvelope& shape, double period, std::size_t blocks) {
  constexpr int kTails = 6;
  PowerCourse power(blocks, 0.0);
  for (std::size_t n = 0; n < blocks * kEnvelopeBlock; ++n)
    for (int k = 0; k <= kTails; ++k) {
      const double a = envelope(shape, static_cast<double>(n) + k * period);
      power[n / kEnvelopeBlock] += a * a;
    }
  return power;
}

/// dB, 0 at the mean of a flat course: curves of the same energy lie on one another.
PowerCourse in_decibels(PowerCourse power) {
  const double mean = std::accumulate(power.begin(), power.end(), 0.0) / static_cast<double>(power.size());
  for (double& p : power) p = 10 * std::log10(std::max(p / std::max(mean, 1e-30), 1e-9));
  return power;
}

std::vector<float> whitened(const std::vector<float>& x) {
  const Eigen::ArrayXf y = whiten(x, lpc_whitener(x, kWhitenerOrder)).cast<float>();
  return {y.data(), y.data() + y.size()};
}

}  // namespace

std::string envelope_panel(const ChainResult& segment) {
  const double period = median_gap(segment.clicks.P);
  const std::vector<float> drilling = segment.drilling.all();
  const PowerCourse recorded = in_decibels(mean_course(segment.clicks.P, drilling)),
                    white = in_decibels(mean_course(segment.clicks.P, whitened(drilling))),
                    fit = in_decibels(fitted_course(segment.clicks.envelope, period, white.size()));
  PowerCourse ms;
  for (std::size_t b = 0; b < fit.size(); ++b)
    ms.push_back(1e3 * (static_cast<double>(b) + 0.5) * kEnvelopeBlock / kAnalysisRate);
  double top = 0, low = 0;
  for (const PowerCourse* course : {&recorded, &white, &fit}) {
    top = std::max(top, *std::max_element(course->begin(), course->end()) + 2);
    low = std::min(low, *std::min_element(course->begin(), course->end()) - 2);
  }
  SvgPlot plot("Envelope", linear_axis("ms after the onset", 0, 1e3 * period / kAnalysisRate),
               linear_axis("dB re the mean", std::max(low, top - kEnvelopeRangeDb), top), kThird);
  plot->line(ms, recorded, {Role::kSecond, 1.6});
  plot->line(ms, white, {Role::kFirst, 1.6});
  plot->line(ms, fit, {Role::kThird, 1.6});
  plot->legend("drilling", Role::kGrey);
  plot->legend("whitened", Role::kFirst);
  plot->legend("fitted", Role::kThird);
  return plot.svg();
}

std::string click_panels(const ClickBank& bank) {
  double longest = 0, peak = 0;
  std::vector<Outline> shapes;
  for (const Click& click : bank.clicks) {
    shapes.push_back(outline(click.data(), click.size(), kClickColumns, 0, 1e3 / bank.sample_rate));
    longest = std::max(longest, 1e3 * static_cast<double>(click.size()) / bank.sample_rate);
    peak = std::max(peak, shapes.back().peak);
  }
  std::string html;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SvgPlot plot(fmt::format("Click {}", i + 1), linear_axis("ms", 0, longest, 3),
                 linear_axis("amplitude", -peak, peak, 2), kFifth);
    plot->band(shapes[i].x, shapes[i].low, shapes[i].high, Role::kFirst);
    html += plot.svg();
  }
  return html;
}

}  // namespace rigsound::analysis
