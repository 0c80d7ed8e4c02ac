#include "diesel/source_point.hpp"

#include <algorithm>

#include "rigsound/dsp/elementary.hpp"

namespace rigsound::diesel {
namespace {

constexpr double kTaper_hz = 1600;
constexpr double kSmallest = 1e-10;  // -200 dB stands for nothing: its logarithm is finite

double ln(double x) { return dsp::log(std::max(x, kSmallest)); }

/// Body on the channels of the low layer; channel q lies at order (q + 1/2) / 2.
void add_body_lo(const DieselModel& model, double rpm, double sign, std::vector<double>& lo) {
  const std::size_t P = static_cast<std::size_t>(model.low_channels);
  for (std::size_t i = 0; i < lo.size(); ++i) {
    const double order = (static_cast<double>(i % P) + 0.5) / 2;
    lo[i] += sign * body_db(model.body, order * cycles_per_second(rpm)) * (dsp::kLn10 / 20);
  }
}

double mixed(double a, double b, double way) { return a + (b - a) * way; }

std::vector<double> mixed(const std::vector<double>& a, const std::vector<double>& b, double way) {
  std::vector<double> y = a.size() >= b.size() ? a : b;  // what only one has stays as it is
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) y[i] = mixed(a[i], b[i], way);
  return y;
}

double wrapped(double phase) { return phase - dsp::kTwoPi * std::floor(phase / dsp::kTwoPi + 0.5); }

/// Along one load: sorted by speed.
SourcePoint along(const DieselModel& model, const std::vector<const DieselPoint*>& row, double rpm) {
  std::size_t upper = 0;
  while (upper < row.size() && row[upper]->rpm < rpm) ++upper;
  if (upper == 0) return source_of(model, *row.front());
  if (upper == row.size()) return source_of(model, *row.back());
  const DieselPoint &a = *row[upper - 1], &b = *row[upper];
  const double way = dsp::log(rpm / a.rpm) / dsp::log(b.rpm / a.rpm);
  return between(source_of(model, a), source_of(model, b), way);
}

}  // namespace

double body_db(const BodyResponse& E, double f_hz) {
  if (E.db.empty()) return 0;
  const double last = static_cast<double>(E.db.size() - 1);
  const double place =
      std::clamp(dsp::log(std::max(f_hz, 1e-3) / E.f_min) / dsp::kLn2 * E.per_octave, 0.0, last);
  const auto i = std::min(static_cast<std::size_t>(place), E.db.size() - 2);
  const double value =
      mixed(static_cast<double>(E.db[i]), static_cast<double>(E.db[i + 1]), place - static_cast<double>(i));
  const double r2 = (f_hz / kTaper_hz) * (f_hz / kTaper_hz);
  return value / (1 + r2 * r2 * r2 * r2);
}

SourcePoint source_of(const DieselModel& model, const DieselPoint& point) {
  SourcePoint s;
  const double f = cycles_per_second(point.rpm);
  for (std::size_t k = 1; k <= point.orders.size(); ++k) {
    const auto re = static_cast<double>(point.orders[k - 1].real()),
               im = static_cast<double>(point.orders[k - 1].imag());
    const double body = body_db(model.body, static_cast<double>(k) * f) * (dsp::kLn10 / 20);
    s.level.push_back(ln(std::sqrt(re * re + im * im)) - body);
    s.phase.push_back(dsp::atan2(im, re));
  }
  for (const float v : point.low_variance) s.lo.push_back(ln(std::sqrt(static_cast<double>(v))));
  for (const float v : point.slot_variance) s.hi.push_back(ln(std::sqrt(static_cast<double>(v))));
  for (const float v : point.slot_log_variance) s.s.push_back(std::sqrt(static_cast<double>(v)));
  s.rho = point.slot_correlation;
  add_body_lo(model, point.rpm, -1, s.lo);
  return s;
}

SourcePoint between(const SourcePoint& a, const SourcePoint& b, double way) {
  SourcePoint y;
  y.level = mixed(a.level, b.level, way);
  y.phase = a.phase.size() >= b.phase.size() ? a.phase : b.phase;
  for (std::size_t i = 0; i < std::min(a.phase.size(), b.phase.size()); ++i)
    y.phase[i] = a.phase[i] + way * wrapped(b.phase[i] - a.phase[i]);
  y.lo = mixed(a.lo, b.lo, way);
  y.hi = mixed(a.hi, b.hi, way);
  y.s = mixed(a.s, b.s, way);
  y.rho = mixed(a.rho, b.rho, way);
  return y;
}

SourcePoint source_at(const DieselModel& model, double rpm, double load) {
  std::vector<double> loads;
  for (const DieselPoint& p : model.points) loads.push_back(p.load);
  std::sort(loads.begin(), loads.end());
  loads.erase(std::unique(loads.begin(), loads.end()), loads.end());
  std::size_t upper = 0;
  while (upper + 1 < loads.size() && loads[upper] < load) ++upper;
  const std::size_t lower = upper > 0 && loads[upper] > load ? upper - 1 : upper;

  const auto at_load = [&](double wanted) {
    std::vector<const DieselPoint*> row;
    for (const DieselPoint& p : model.points)
      if (p.load == wanted) row.push_back(&p);
    std::sort(row.begin(), row.end(), [](const auto* a, const auto* b) { return a->rpm < b->rpm; });
    return along(model, row, rpm);
  };
  if (lower == upper) return at_load(loads[upper]);
  return between(at_load(loads[lower]), at_load(loads[upper]),
                 (load - loads[lower]) / (loads[upper] - loads[lower]));
}

}  // namespace rigsound::diesel
